"""Rules that need the repository: all of the package ships, nothing else does, and its versions agree."""
import re

from .package import files_below
from .picture_rules import is_illustration
from .problem import Problem, at_offset
from .whitelist import NEVER

FOLDERS = ("Runtime", "Editor", "Shaders", "ShaderLibrary", "Samples~", "Documentation~")
FILES = ("package.json", "README.md", "LICENSE.md", "CHANGELOG.md", "Third Party Notices.md")
MANIFEST = "package.json"


def may_ship(path):
    top = path.split("/")[0]
    return top in FOLDERS or path in FILES or path.endswith(".meta") and path[:-5] in (*FILES, *FOLDERS)


def may_be_left_out(path):
    """Pictures and results: link_rules says where a page misses one. Pages always ship."""
    return is_illustration(path) and not path.endswith(".md")


def whitelist_problems(root, package):
    for path in package.paths:
        if not may_ship(path):
            yield Problem(MANIFEST, f"'files' ships {path}, which is not part of the package: remove it")
    for path in files_below(root, FOLDERS):
        if may_ship(path) and path not in package.files and not may_be_left_out(path) and not NEVER.search(path):
            entry = path.split("/")[0] + "/" if "/" in path else path
            yield Problem(MANIFEST, f"'files' leaves out {path}: add \"{entry}\"")


def version_problems(root, package):
    path = "CMakeLists.txt"
    try:
        text = (root / path).read_text(encoding="utf-8")
    except OSError as error:
        yield Problem(path, f"cannot be read: {error.strerror}")
        return
    wanted = package.manifest().get("version")
    if wanted is None:
        return  # manifest_rules says so
    found = re.search(r"^project\(\s*\w+\s+VERSION\s+([\w.]+)", text, re.MULTILINE)
    core = str(wanted).partition("-")[0]  # CMake knows no pre-releases
    if found is None:
        yield Problem(path, f"has no project(... VERSION {core}): add it")
    elif found[1] != core:
        yield at_offset(path, text, found.start(1),
                        f"the project's version is {found[1]}, package.json's is {wanted}: make them one")


def check(root, package):
    yield from whitelist_problems(root, package)
    yield from version_problems(root, package)
