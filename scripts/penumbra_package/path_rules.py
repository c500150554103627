"""File names that are valid on every system, that npm packs as configured, and that Unity imports as intended."""
import posixpath
import re

from .package import is_visible
from .problem import Problem

# Unity imports these as native code of players (Unity's manual, "Import and configure plug-ins").
NATIVE = {".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx", ".java", ".jslib", ".jspre", ".kt", ".m", ".mm",
          ".swift"}
CHANGES_WHITELIST = (".gitignore", ".npmignore")
# Characters that Windows rejects in a name, and others that no name should need.
UNUSABLE = re.compile(r'[<>:"|?*\\\x00-\x1f\x7f]|[. ](/|$)|[^\x00-\x7f]')


def of_one_path(package, path):
    name = posixpath.basename(path)
    if (package.root / path).is_symlink():
        return "is a link, which npm leaves out: put the file itself there"
    if name in CHANGES_WHITELIST:
        return "changes what npm packs of this folder: remove it and use 'files' of package.json"
    if any(part.startswith(".") for part in path.split("/")):
        return "is hidden, so Unity never sees it: remove it or take it out of 'files' of package.json"
    if UNUSABLE.search(path):
        return "has a name that not every system can hold: use ASCII letters, digits and ' ._~-()' for it"
    extension = posixpath.splitext(name)[1].lower()
    if extension in NATIVE and is_visible(path):
        return (f"Unity imports '{extension}' files as native code of players: "
                "move it below a folder whose name ends in '~'")
    return None


def check(package):
    for path in package.paths:
        text = of_one_path(package, path)
        if text:
            yield Problem(path, text)
    by_folded = {}
    for path in sorted(package.files | package.folders):
        other = by_folded.setdefault(path.lower(), path)
        if other != path:
            yield Problem(path, f"differs from {other} only in case, which Windows and macOS do not distinguish: rename one")
