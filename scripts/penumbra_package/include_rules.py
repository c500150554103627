"""Every #include of a shader file resolves to a file, with its exact case.

Paths are as Unity reads them: from the including file's folder, or "Packages/NAME/..." (Unity's manual, "include and
include_with_pragmas directives in HLSL"). Files of another package are looked for where its folder is given.
"""
import os
import posixpath
import re

from .package import NAME
from .problem import at_offset

SHADERS = (".hlsl", ".cginc", ".shader", ".compute", ".raytrace")
# What comes with a package of ours that depends on the key: its own package.json names them at 14.0 and at 17.0.
BRINGS = {"com.unity.render-pipelines.universal": ("com.unity.render-pipelines.core",
                                                   "com.unity.render-pipelines.universal-config")}
# Bindings for a pipeline that a project has or has not: no other file leads to them, and nothing is imported with them.
OPTIONAL = {"ShaderLibrary/Pipelines/Hdrp.hlsl": ("com.unity.render-pipelines.high-definition",)}
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"[^"\n]*"', re.DOTALL)
INCLUDE = re.compile(r"^[ \t]*#[ \t]*include(?:_with_pragmas)?\b[ \t]*(.*?)[ \t\r]*$", re.MULTILINE)


def without_comments(text):
    """The text with spaces for its comments, so that places in it stay."""
    return COMMENT_OR_TEXT.sub(lambda match: match[0] if match[0][0] == '"' else re.sub(r"[^\n]", " ", match[0]), text)


def includes(text):
    """The argument of each #include, as written, with its location."""
    for match in INCLUDE.finditer(without_comments(text)):
        yield match[1], match.start(1)


def case_on_disk(root, path):
    """The path with the case that it has on disk below the root, or None if it does not exist in any case."""
    real = []
    for part in path.split("/"):
        folder = os.path.join(root, *real)
        names = os.listdir(folder) if os.path.isdir(folder) else []
        fits = [name for name in names if name.lower() == part.lower()]
        if not fits:
            return None
        real.append(part if part in fits else fits[0])
    return "/".join(real)


def case_in_package(package, path):
    return path if path in package.files else next((one for one in package.paths if one.lower() == path.lower()), None)


def compared(wanted, real, where):
    if real is None:
        return f"there is no {wanted} in {where}: correct the path"
    return None if real == wanted else f"{wanted} is written {real} in {where}: write it so"


class Includes:
    def __init__(self, package, roots):
        self.package, self.roots = package, roots
        given = package.manifest().get("dependencies")
        dependencies = set(given) if isinstance(given, dict) else set()
        self.reachable = dependencies.union(*(BRINGS.get(name, ()) for name in dependencies))

    def from_package(self, including, name, path):
        if name == NAME:
            return compared(path, case_in_package(self.package, path), "the package")
        if name not in self.reachable and name not in OPTIONAL.get(including, ()):
            return f"{name} is not a dependency of package.json: add it there, or do without its file"
        if name in self.roots:
            return compared(path, case_on_disk(self.roots[name], path), name)
        return None

    def from_folder(self, including, path):
        wanted = posixpath.normpath(posixpath.join(posixpath.dirname(including), path))
        if wanted.startswith("../"):
            return f"{path} leads out of the package: write \"Packages/NAME/...\" for a file of another one"
        sample = "/".join(including.split("/")[:2]) + "/"
        if including.startswith("Samples~/") and not wanted.startswith(sample):
            return f"{path} leads out of the sample, which is copied into projects: write \"Packages/{NAME}/...\""
        return compared(wanted, case_in_package(self.package, wanted), "the package")

    def problem(self, including, target):
        if not re.fullmatch(r'"[^"]+"', target):
            return f"what {target or 'nothing'} leads to is not known here: write the path in quotes"
        path = target[1:-1]
        if "\\" in path:
            return f"{path} has '\\', which is not a separator on Linux and macOS: write '/'"
        if path.startswith("Packages/"):
            _, name, *rest = path.split("/")
            return self.from_package(including, name, posixpath.normpath("/".join(rest)))
        return self.from_folder(including, path)


def check(package, roots):
    known = Includes(package, roots)
    for including in package.ending(*SHADERS):
        text = package.text(including)
        for target, offset in includes(text):
            message = known.problem(including, target)
            if message:
                yield at_offset(including, text, offset, message)
