"""The files of a package below a folder: the work tree's that ship, or all of an unpacked tarball.

Paths are relative to the package's root, with '/', and sorted.
"""
import json
import os
import posixpath
from pathlib import Path

from .problem import Stop

NAME = "com.penumbra.shadows"


def files_below(root, only=None):
    """Every file's path; a link to a folder counts as a file, as nothing follows it. With `only`, of the root's own
    folders just these are looked into."""
    found = []
    for folder, names, files in os.walk(root):
        here = Path(folder)
        if only is not None and here == Path(root):
            names[:] = [name for name in names if name in only]
        links = [name for name in names if (here / name).is_symlink()]
        names[:] = [name for name in names if name not in links]
        found += [(here / name).relative_to(root).as_posix() for name in files + links]
    return sorted(found)


def hides_from_unity(name):
    return name.startswith(".") or name.endswith("~")


def is_visible(path):
    """Whether Unity imports the path: no part of it is hidden (Unity's manual, "Special folder names")."""
    return not any(hides_from_unity(part) for part in path.split("/"))


def is_imported(path):
    """Whether Unity imports the path: from the package, or from a project into which a sample's content was copied, which
    takes the .meta files along."""
    parts = path.split("/")
    return is_visible("/".join(parts[2:]) if parts[0] == "Samples~" and len(parts) > 2 else path)


def folders_above(path):
    above = posixpath.dirname(path)
    while above:
        yield above
        above = posixpath.dirname(above)


class Package:
    """`sources` names the file below the root that a path's content comes from, where that is another."""

    def __init__(self, root, paths, sources=None):
        self.root = Path(root)
        self.paths = sorted(paths)
        self.sources = sources or {}
        self.files = frozenset(self.paths)
        self.folders = frozenset(above for path in self.paths for above in folders_above(path))

    def source(self, path):
        return self.sources.get(path, path)

    def bytes(self, path):
        try:
            return (self.root / self.source(path)).read_bytes()
        except OSError as error:
            raise Stop(f"{self.source(path)}: cannot be read: {error.strerror}") from error

    def text(self, path):
        try:
            return self.bytes(path).decode("utf-8")
        except UnicodeDecodeError as error:
            raise Stop(f"{self.source(path)}: is not UTF-8 at byte {error.start}: save it as UTF-8") from error

    def manifest(self):
        """package.json's object; an empty one where manifest_rules has something to say about it."""
        try:
            value = json.loads(self.text("package.json")) if "package.json" in self.files else {}
        except (ValueError, RecursionError):
            return {}
        return value if isinstance(value, dict) else {}

    def ending(self, *ends):
        return [path for path in self.paths if path.endswith(ends)]


def unpacked(folder):
    """The package that is all of a folder."""
    return Package(folder, files_below(folder))
