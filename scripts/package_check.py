#!/usr/bin/env python3
"""Finds in the unpacked package what users of Unity would meet as errors: scripts/package_check.py FOLDER

Each rule is a function; words in quotes are chapters of Unity's manual. If PENUMBRA_URP_PACKAGES names folders of
Unity's packages, the files that shaders include from them are looked for, too. Exit code 1: problems, one a line.
"""
import json
import os
import posixpath
import re
import sys
from pathlib import Path, PurePosixPath
from urllib.parse import unquote

NAME = "com.penumbra.shadows"
INDEX = "Documentation~/index.md"  # The Package Manager opens it.
REQUIRED = ("README.md", "LICENSE.md", "CHANGELOG.md", "Third Party Notices.md", INDEX)
UNFIT_NAME = re.compile(r'[<>:"|?*\\]|[^ -~]|[. ](/|$)|(^|/)(con|prn|aux|nul|com\d|lpt\d)(\.|/|$)', re.I)
NATIVE = re.compile(r"\.(c|cc|cpp|cxx|h|hh|hpp|hxx|java|jslib|jspre|kt|m|mm|swift)$")
SEMANTIC_VERSION = re.compile(r"\d+\.\d+\.\d+(-[0-9A-Za-z.-]+)?")
VERSION_RANGE = re.compile(r"|\d[\w.-]*|\[\d[\w.-]*\]|[\[(]\d[\w.-]*,\d[\w.-]*[\])]")
RELEASE = re.compile(r"^## \[(\d[^\]]*)\] - (\d{4}-\d\d-\d\d|Unreleased)$", re.MULTILINE)
PLAYER_ASSEMBLIES = {"Unity.RenderPipelines.Core.Runtime", "Unity.RenderPipelines.Universal.Runtime"}
EDITOR_ASSEMBLIES = {"Unity.RenderPipelines.Core.Editor", "Unity.RenderPipelines.Universal.Editor"}
URP = "com.unity.render-pipelines.universal"
BROUGHT_BY_URP = ("com.unity.render-pipelines.core", "com.unity.render-pipelines.universal-config")
FOR_HDRP_ALONE = ("com.unity.render-pipelines.high-definition", "ShaderLibrary/Pipelines/Hdrp.hlsl")
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"[^"\n]*"', re.DOTALL)
INCLUDE = re.compile(r"^[ \t]*#[ \t]*include(?:_with_pragmas)?\b[ \t]*(.*?)[ \t\r]*$", re.MULTILINE)
CODE = re.compile(r"^(```|~~~).*?^\1[ \t]*$|`[^`\n]*`", re.DOTALL | re.MULTILINE)
LINK = re.compile(r'\]\(\s*<?(?![A-Za-z][\w+.-]*:|#)([^)\s>]+)>?(?:\s+"[^"]*")?\s*\)')
TRANSCRIBED = re.compile(r"google/filament|godotengine/godot|Google's Filament|FilamentTaps\.hlsl")


def is_visible(path):
    """Whether Unity imports the path ("Special folder names"), perhaps from a sample that was copied into a project."""
    return not re.search(r"(^|/)\.|~(/|$)", re.sub("^Samples~/[^/]+/", "", path))


def wanted_metas(paths):
    """The .meta files that belong to the imported ones of `paths` and to their folders."""
    imported = {path for path in paths if is_visible(path) and not path.endswith(".meta")}
    folders = {above.as_posix() for path in imported for above in PurePosixPath(path).parents[:-1]}
    return {f"{path}.meta" for path in imported | folders if is_visible(path)}


class Package:
    def __init__(self, folder):
        self.folder = Path(folder)
        found = {path.relative_to(folder).as_posix(): path for path in self.folder.rglob("*")}
        self.files = {name for name, path in found.items() if path.is_file()}
        self.folders = found.keys() - self.files
        self.manifest = self.json("package.json")

    def ending(self, *ends):
        return sorted(path for path in self.files if path.endswith(ends))

    def text(self, path):
        return (self.folder / path).read_text(encoding="utf-8") if path in self.files else ""

    def json(self, path):
        try:
            return json.loads(self.text(path))
        except ValueError as error:
            sys.exit(f"{path}: is not JSON: {error}")


def names(package):
    folded = {}
    for path in sorted(package.files | package.folders):
        if UNFIT_NAME.search(path):
            yield f"{path}: Windows cannot hold this name, or it is not ASCII"
        if folded.setdefault(path.lower(), path) != path:
            yield f"{path}: differs only in case from {folded[path.lower()]}"
        if NATIVE.search(path) and is_visible(path):
            yield f"{path}: Unity compiles such files into players as native code"


def metas(package):
    wanted, given = wanted_metas(package.files), set(package.ending(".meta"))
    yield from (f"{meta[:-5]}: has no .meta: run scripts/package --metas" for meta in wanted - given)
    yield from (f"{meta}: belongs to nothing that Unity imports" for meta in given - wanted)
    owners = {}
    for meta in sorted(given & wanted):
        found = re.search(r"^guid: ([0-9a-f]{32})$", package.text(meta), re.MULTILINE)
        if not found:
            yield f"{meta}: has no guid of 32 digits"
        elif owners.setdefault(found[1], meta) != meta:
            yield f"{meta}: has the guid of {owners[found[1]]}"


def manifest(package):  # "Package manifest"
    value = package.manifest
    yield from (f"{path}: is missing" for path in REQUIRED if path not in package.files)
    dependencies = value.get("dependencies", {})
    newest = RELEASE.search(package.text("CHANGELOG.md"))
    rules = [(value.get("name") == NAME, f"'name' is not {NAME}"),
             (newest and newest[1] == value.get("version"), "'version' is not that of the changelog's newest release"),
             (re.fullmatch(r"\d{4}\.\d+", value.get("unity", "")), "'unity' is not a version like 2022.3"),
             (value.get("displayName") and value.get("description"), "'displayName' or 'description' is empty"),
             (URP in dependencies, f"'dependencies' is without {URP}"),
             *((SEMANTIC_VERSION.fullmatch(text), f"'{text}' is not a semantic version")
               for text in (value.get("version", ""), *dependencies.values()))]
    yield from (f"package.json: {text}" for holds, text in rules if not holds)
    shown = {sample.get("path") for sample in value.get("samples", []) if sample.get("displayName")}
    folders = {f"Samples~/{path.split('/')[1]}" for path in package.folders if path.startswith("Samples~/")}
    yield from (f"package.json: the samples list and the folders differ in {path}" for path in shown ^ folders)


def assemblies(package):
    """"Organizing scripts into assemblies": scripts of a package that are in none are not compiled at all."""
    definitions = {path: package.json(path) for path in package.ending(".asmdef")}
    owners = {value["name"]: path for path, value in definitions.items()}
    covered = {posixpath.dirname(path) for path in package.ending(".asmdef", ".asmref")}
    for_editor = {value["name"] for value in definitions.values() if value.get("includePlatforms") == ["Editor"]}
    for path, value in definitions.items():
        is_for_editor = value["name"] in for_editor
        if owners[value["name"]] != path:
            yield f"{path}: has the name of {owners[value['name']]}"
        if "Editor" in path.split("/")[:-1] and not is_for_editor:
            yield f"{path}: is in a folder Editor, but not for the platform Editor alone"
        for reference in value.get("references", []):
            if reference not in owners.keys() | PLAYER_ASSEMBLIES | EDITOR_ASSEMBLIES:
                yield f"{path}: there is no assembly {reference}"
            elif reference in for_editor | EDITOR_ASSEMBLIES and not is_for_editor:
                yield f"{path}: players do not have {reference}"
        for define in value.get("versionDefines", []):
            if not VERSION_RANGE.fullmatch(define["expression"]):
                yield f"{path}: '{define['expression']}' is no range of versions like [14.0,17.0)"
    for path in package.ending(".cs"):
        if is_visible(path) and not covered & {above.as_posix() for above in PurePosixPath(path).parents}:
            yield f"{path}: belongs to no assembly definition, so Unity does not compile it"


def blanked(pattern, text):
    """The text with spaces for what the pattern finds, except between quotes; the lines stay."""
    return pattern.sub(lambda found: found[0] if found[0][0] == '"' else re.sub(r"[^\n]", " ", found[0]), text)


def line_of(match):
    return match.string.count("\n", 0, match.start()) + 1


def include_problem(package, including, target, others):
    path = target[1:-1]
    if target != f'"{path}"':
        return f"{target} is not a path in quotes"
    if path.startswith("Packages/"):
        _, name, path = path.split("/", 2)
        known = {NAME, *BROUGHT_BY_URP, *package.manifest.get("dependencies", {})}
        if name not in known and (name, including) != FOR_HDRP_ALONE:
            return f"{name} is not a dependency of the package"
        if name != NAME:
            given = [folder / name for folder in others if (folder / name).is_dir()]
            is_gone = given and not any((folder / path).is_file() for folder in given)
            return f"there is no {path} in {name}" if is_gone else None
    else:
        path = posixpath.normpath(posixpath.join(posixpath.dirname(including), path))
        if including.startswith("Samples~/") and path.split("/")[:2] != including.split("/")[:2]:
            return f"{target} leads out of the sample, which is copied into projects"
    return None if path in package.files else f"there is no {path} in the package"


def includes(package):
    others = [Path(folder) for folder in os.environ.get("PENUMBRA_URP_PACKAGES", "").split(os.pathsep) if folder]
    for including in package.ending(".hlsl", ".cginc", ".shader", ".compute", ".raytrace"):
        for match in INCLUDE.finditer(blanked(COMMENT_OR_TEXT, package.text(including))):
            if problem := include_problem(package, including, match[1], others):
                yield f"{including}:{line_of(match)}: {problem}"


def pages(package):
    """Links lead to what ships. A page without a link to it is not found; a picture without one is useless weight."""
    there, reached = package.files | package.folders, {INDEX}
    for page in package.ending(".md"):
        for match in LINK.finditer(blanked(CODE, package.text(page))):
            target = posixpath.normpath(posixpath.join(posixpath.dirname(page), unquote(match[1].split("#")[0])))
            reached.add(target)
            if target not in there:
                yield f"{page}:{line_of(match)}: {match[1]} is not in the package"
    yield from (f"{path}: no page leads to it: link it, or leave it out by a '!' in 'files' of package.json"
                for path in package.files - reached if path.startswith("Documentation~/"))


def notices(package):
    text = package.text("Third Party Notices.md")
    named = set(re.findall(r"`((?:ShaderLibrary|Runtime)/[^`]+)`", text))
    yield from (f"Third Party Notices.md: there is no {path}" for path in named - package.files)
    yield from (f"Third Party Notices.md: {path} is transcribed and not named" for path in package.ending(".hlsl")
                if path not in named and TRANSCRIBED.search(package.text(path).split("#ifndef")[0]))


def problems(folder):
    rules = (names, metas, manifest, assemblies, includes, pages, notices)
    package = Package(folder)
    return sorted(problem for rule in rules for problem in rule(package))


if __name__ == "__main__":
    sys.exit("\n".join(problems(*sys.argv[1:])) or 0)
