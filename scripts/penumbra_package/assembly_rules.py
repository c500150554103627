"""Assembly definitions: what they refer to is there, editor code stays out of players, no script is without one.

Scripts of an installed package that no assembly definition covers are not compiled at all (Unity's manual, "Organizing
scripts into assemblies", and "Package layout").
"""
import posixpath
import re

from .located_json import Document, Malformed
from .metas import guid
from .package import folders_above, is_visible
from .problem import Problem

# The assemblies of Unity that this package may stand on.
PLAYER_ASSEMBLIES = {"Unity.RenderPipelines.Core.Runtime", "Unity.RenderPipelines.Universal.Runtime",
                     "UnityEngine.TestRunner"}
EDITOR_ASSEMBLIES = {"Unity.RenderPipelines.Core.Editor", "Unity.RenderPipelines.Universal.Editor",
                     "UnityEditor.TestRunner"}

# Versions and ranges of them (Unity's manual, "Conditionally including assemblies", version defines).
VERSION = r"\d+(?:\.\d+){0,3}(?:[abfp]\d+|-[0-9A-Za-z.-]+)?"
EXPRESSION = re.compile(rf"|{VERSION}|\[{VERSION}\]|[\[(]{VERSION},{VERSION}[\])]", re.ASCII)
RESOURCE = re.compile(r"Unity|[a-z0-9-]+(?:\.[a-z0-9-]+)+", re.ASCII)
SYMBOL = re.compile(r"[A-Za-z_]\w*", re.ASCII)


def in_editor_folder(path):
    return "Editor" in path.split("/")[:-1]


def is_for_editor_alone(document):
    return document.value.get("includePlatforms") == ["Editor"]


def references(document, owners, guids):
    """`owners` are the package's assemblies by name, `guids` their names."""
    given = document.value.get("references", [])
    if not isinstance(given, list):
        yield document.problem(("references",), "'references' is not a list: write one of assembly names")
        return
    not_in_players = EDITOR_ASSEMBLIES | {name for name, owner in owners.items() if is_for_editor_alone(owner)}
    known = owners.keys() | PLAYER_ASSEMBLIES | EDITOR_ASSEMBLIES
    for index, reference in enumerate(given):
        place = ("references", index)
        name = guids.get(reference[5:]) if isinstance(reference, str) and reference.startswith("GUID:") else reference
        if not isinstance(name, str) or name not in known:
            yield document.problem(place, f"'{reference}' is not an assembly of this package, nor one of Unity's that it may "
                                          "use: write the name of one, or add it to "
                                          "scripts/penumbra_package/assembly_rules.py")
        elif name in not_in_players and not is_for_editor_alone(document):
            yield document.problem(place, f"'{name}' is not in players: refer to it from an assembly for the platform "
                                          "Editor alone")


def version_defines(document):
    given = document.value.get("versionDefines", [])
    if not isinstance(given, list):
        yield document.problem(("versionDefines",),
                               "'versionDefines' is not a list: write one of {name, expression, define}")
        return
    forms = {"name": (RESOURCE, "a package's name or Unity"),
             "expression": (EXPRESSION, "a version or a range like [14.0,17.0)"),
             "define": (SYMBOL, "a C# symbol")}
    for index, entry in enumerate(given):
        for key, (form, meaning) in forms.items():
            value = entry.get(key) if isinstance(entry, dict) else None
            if not isinstance(value, str) or not form.fullmatch(value):
                yield document.problem(("versionDefines", index, key),
                                       f"'{key}' of the version define is not {meaning}: write one")


def platforms(document):
    included, excluded = (document.value.get(key, []) for key in ("includePlatforms", "excludePlatforms"))
    if included and excluded:
        yield document.problem(("excludePlatforms",),
                               "'excludePlatforms' and 'includePlatforms' are both given: Unity takes one")
    if in_editor_folder(document.path) and not is_for_editor_alone(document):
        yield document.problem(("includePlatforms",), "an assembly of an Editor folder is not for the platform Editor "
                                                      "alone: write \"includePlatforms\": [\"Editor\"]")


def scripts_without_assembly(package, covered):
    for path in package.ending(".cs"):
        if is_visible(path) and not covered.intersection(folders_above(path)):
            yield Problem(path, "belongs to no assembly definition, so Unity does not compile it: "
                                "add one to its folder")


def check(package):
    documents = []
    for path in package.ending(".asmdef"):
        try:
            documents.append(Document(path, package.text(path)))
        except Malformed as error:
            yield error.problem
    owners = {}
    for document in documents:
        name = document.value.get("name") if isinstance(document.value, dict) else None
        if not isinstance(name, str) or not name:
            yield document.problem(("name",) if isinstance(document.value, dict) else (),
                                   "has no 'name': write the assembly's")
        elif owners.setdefault(name, document) is not document:
            yield document.problem(("name",), f"'{name}' is the name of {owners[name].path}, too: take another")
    guids = {guid(document.path): name for name, document in owners.items()}
    for document in owners.values():
        yield from references(document, owners, guids)
        yield from version_defines(document)
        yield from platforms(document)
    covered = {posixpath.dirname(path) for path in package.ending(".asmdef", ".asmref")}
    yield from scripts_without_assembly(package, covered)
