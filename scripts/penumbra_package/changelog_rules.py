"""CHANGELOG.md in the form of https://keepachangelog.com/en/1.1.0/, its newest version the package's."""
import datetime
import re

from .manifest_rules import SEMANTIC_VERSION
from .problem import Problem, at_offset

PATH = "CHANGELOG.md"
HEADING = re.compile(r"^## (.*?)[ \t]*$", re.MULTILINE)
FORM = re.compile(r"\[([^\]]+)\](?: - (\S+))?")
KINDS = ("Added", "Changed", "Deprecated", "Removed", "Fixed", "Security")


def is_date(text):
    try:
        return datetime.date.fromisoformat(text).isoformat() == text
    except ValueError:
        return False


def order(version):
    """Sorts as https://semver.org does: numbers by value, before words, and a pre-release before its release."""
    core, _, words = version.partition("-")
    ranks = [(0, int(word), "") if word.isdigit() else (1, 0, word) for word in words.split(".")] if words else []
    return [int(number) for number in core.split(".")], not words, ranks


def headings(text):
    """Of each release, newest first, the version (None for "Unreleased") and the place; or a problem instead."""
    for match in HEADING.finditer(text):
        form = FORM.fullmatch(match[1])
        version, date = form.groups() if form else (None, None)
        if form and version == "Unreleased" and date is None:
            yield None, match.start()
        elif form and SEMANTIC_VERSION.fullmatch(version) and date and (date == "Unreleased" or is_date(date)):
            yield version, match.start()
        else:
            message = (f"'## {match[1]}' heads no release: write '## [1.2.3] - 2026-01-31', '## [1.2.3] - Unreleased' "
                       "or '## [Unreleased]'")
            yield at_offset(PATH, text, match.start(), message), match.start()


def check_headings(text):
    newest = True
    before = None
    for version, offset in headings(text):
        if isinstance(version, Problem):
            yield version
        elif version is None and not newest:
            yield at_offset(PATH, text, offset, "'## [Unreleased]' stands below a release: move it to the top")
        elif version and before and order(version) >= order(before):
            yield at_offset(PATH, text, offset,
                            f"{version} stands below {before}: the newest release comes first, each once")
        before = version if isinstance(version, str) else before
        newest = False


def check_kinds(text):
    for match in re.finditer(r"^### (.*?)[ \t]*$", text, re.MULTILINE):
        if match[1] not in KINDS:
            yield at_offset(PATH, text, match.start(),
                            f"'### {match[1]}' is not a kind of change: write one of {', '.join(KINDS)}")


def newest_version(text):
    return next((found for found in headings(text) if isinstance(found[0], str)), (None, 0))


def check(package):
    if PATH not in package.files:
        return  # manifest_rules says so
    text = package.text(PATH)
    yield from check_headings(text)
    yield from check_kinds(text)
    version, offset = newest_version(text)
    wanted = package.manifest().get("version")
    if wanted is not None and version != wanted:
        yield at_offset(PATH, text, offset,
                        f"the newest version is {version or 'missing'}, package.json's is {wanted}: make them one")
