"""A .meta for every path that Unity imports, a path for every .meta, and each GUID the one derived from its path."""
import re

from .metas import guid, importer, wants_meta
from .package import is_imported
from .problem import Problem, at_offset

REMAKE = "remove it and run scripts/package --metas"


def guid_problem(package, meta, text, owners):
    found = re.search(r"^guid: ?(.*)$", text, re.MULTILINE)
    if found is None or not re.fullmatch("[0-9a-f]{32}", found[1]):
        message = f"has no guid of 32 digits 0-9a-f: {REMAKE}"
        return at_offset(meta, text, found.start(), message) if found else Problem(meta, message)
    wanted = guid(meta[:-5])
    if found[1] == wanted:
        return None
    owner = owners.get(found[1])
    what = f"has the guid of {owner}" if owner else f"has another guid than the {wanted} that its path gives"
    return at_offset(meta, text, found.start(1), f"{what}: {REMAKE}")


def importer_problem(package, meta, text):
    path = meta[:-5]
    is_folder = path in package.folders
    wanted = "DefaultImporter" if is_folder else importer(path)
    if wanted and not re.search(rf"^{wanted}:$", text, re.MULTILINE):
        return Problem(meta, f"names no {wanted}, which imports {'folders' if is_folder else 'such files'}: {REMAKE}")
    if is_folder and "\nfolderAsset: yes\n" not in text:
        return Problem(meta, f"does not say that its path is a folder: {REMAKE}")
    return None


def check(package):
    for path in sorted(wants_meta(package)):
        if f"{path}.meta" not in package.files:
            yield Problem(path, f"has no {path}.meta in the package: run scripts/package --metas")
    owners = {guid(path): path for path in package.files | package.folders if not path.endswith(".meta")}
    for meta in package.ending(".meta"):
        if meta[:-5] not in package.files | package.folders:
            yield Problem(meta, f"belongs to {meta[:-5]}, which is not in the package: remove it, or bring that back")
        elif not is_imported(meta):
            yield Problem(meta, "is in a folder where Unity reads no .meta files: remove it")
        else:
            text = package.text(meta)
            found = (guid_problem(package, meta, text, owners), importer_problem(package, meta, text))
            yield from (problem for problem in found if problem)
