"""package.json as Unity's Package Manager reads it (Unity's manual, "Package manifest")."""
import re

from .located_json import Document, Malformed
from .package import NAME
from .problem import Problem

UNITY = "2022.3"
URP, URP_VERSION = "com.unity.render-pipelines.universal", "14.0.0"
REQUIRED_FILES = ("package.json", "README.md", "LICENSE.md", "CHANGELOG.md", "Third Party Notices.md")

# https://semver.org, without build metadata: two versions that differ in it alone are one to a package manager.
NUMBER, WORD = r"(?:0|[1-9]\d*)", r"(?:0|[1-9]\d*|\d*[A-Za-z-][0-9A-Za-z-]*)"
SEMANTIC_VERSION = re.compile(rf"{NUMBER}\.{NUMBER}\.{NUMBER}(?:-{WORD}(?:\.{WORD})*)?", re.ASCII)
ADDRESS = re.compile(r"https://[a-z0-9-]+(\.[a-z0-9-]+)+(/[^\s]*)?")


def is_text(value):
    return isinstance(value, str) and value.strip() != ""


def fixed_values(document):
    for key, wanted in (("name", NAME), ("unity", UNITY)):
        if document.value.get(key) != wanted:
            yield document.problem((key,), f"'{key}' is not \"{wanted}\": write that")
    version = document.value.get("version")
    if not is_text(version) or not SEMANTIC_VERSION.fullmatch(version):
        yield document.problem(("version",),
                               "'version' is not a semantic version: write one like \"1.2.3\" or \"1.2.3-pre.1\"")
    for key in ("displayName", "description"):
        if not is_text(document.value.get(key)):
            yield document.problem((key,), f"'{key}' is empty, and the Package Manager shows it: write one")


def dependencies(document):
    given = document.value.get("dependencies")
    if not isinstance(given, dict):
        yield document.problem(("dependencies",),
                               f"'dependencies' is not an object: write {{\"{URP}\": \"{URP_VERSION}\"}}")
        return
    for name, version in given.items():
        if not is_text(version) or not SEMANTIC_VERSION.fullmatch(version):
            yield document.problem(("dependencies", name),
                                   f"the version of {name} is not a semantic version: write one like \"1.2.3\"")
    if is_text(given.get(URP)) and given[URP] == URP_VERSION:
        return
    yield document.problem(("dependencies", URP), f"the dependency on {URP} is not \"{URP_VERSION}\", "
                                                  f"the first version for Unity {UNITY}: write that")


def addresses(document):
    for key in ("documentationUrl", "changelogUrl", "licensesUrl"):
        value = document.value.get(key)
        if key in document.value and not (is_text(value) and ADDRESS.fullmatch(value)):
            yield document.problem((key,),
                                   f"'{key}' is not an address: write one that begins with https://, or leave it out")


def samples(document, package):
    given = document.value.get("samples", [])
    if not isinstance(given, list):
        yield document.problem(("samples",), "'samples' is not a list: write one of {displayName, description, path}")
        return
    there = {path.split("/")[1] for path in package.paths if path.startswith("Samples~/") and path.count("/") > 1}
    listed = set()
    for index, sample in enumerate(given):
        sample = sample if isinstance(sample, dict) else {}
        for key in ("displayName", "description"):
            if not is_text(sample.get(key)):
                yield document.problem(("samples", index, key),
                                       f"the sample has no '{key}', which the Package Manager shows: write one")
        path = sample.get("path")
        folder = path[len("Samples~/"):] if is_text(path) and path.startswith("Samples~/") else ""
        if folder not in there:
            yield document.problem(("samples", index, "path"),
                                   "the sample's 'path' is not a folder of Samples~ with files in it: write \"Samples~/NAME\"")
        listed.add(folder)
    for folder in sorted(there - listed):
        yield document.problem(("samples",),
                               f"Samples~/{folder} is in no entry of 'samples', so nobody can import it: add one")


def check(package):
    for path in REQUIRED_FILES:
        if path not in package.files:
            yield Problem(path, "is not in the package, and every package has one: "
                                "write it, or add it to 'files' of package.json")
    if "package.json" not in package.files:
        return
    try:
        document = Document("package.json", package.text("package.json"))
    except Malformed as error:
        yield error.problem
        return
    if not isinstance(document.value, dict):
        yield document.problem((), "is not a JSON object: write one with name, version and unity")
        return
    yield from fixed_values(document)
    yield from dependencies(document)
    yield from addresses(document)
    yield from samples(document, package)
