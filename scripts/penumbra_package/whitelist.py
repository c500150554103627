"""Which files of the work tree ship: those that package.json's `files` names, as `npm pack` reads it.

Of npm's pattern language this takes what needs no second thought: 'a.md' is a file, 'folder/' all below it, '*' any
name, '**/' any folders (the first of all is named), and a '!' before a pattern takes away what earlier ones gave. The
rest is refused.
"""
import json
import re

from .package import Package, files_below
from .problem import Stop

# Files that npm packs whatever `files` says, and files that it always omits (npm's manual, "package.json", files).
ALWAYS = re.compile(r"package\.json|(README|LICEN[CS]E)(\.[^/]*)?", re.IGNORECASE)
NEVER = re.compile(r"(^|/)(\..*\.swp|\._[^/]*|\.DS_Store|\.npmrc|[^/]*\.orig|npm-debug\.log|(CVS|\.svn|\.hg)/.*)$")

# The repository's README is for everybody who builds, measures or installs; the package's for its users.
SOURCES = {"README.md": "scripts/package-readme.md"}

FORM = re.compile(r"!?(?:[\w~-][\w~. -]*/[\w~.* /-]*|[\w~*][\w~.* -]*)")


def pattern(entry):
    """A regular expression of the paths that one entry names."""
    if not isinstance(entry, str) or not FORM.fullmatch(entry):
        raise Stop(f"package.json: the entry {json.dumps(entry)} of 'files' has a form that scripts/package does not read: "
                   "write 'file', 'folder/', '*', '**/' or '!' before one of these")
    words = {"**/": "(?:.*/)?", "**": ".*", "*": "[^/]*"}
    text = "".join(words.get(word, re.escape(word)) for word in re.findall(r"\*\*/|\*\*|\*|[^*]+", entry.lstrip("!")))
    return re.compile(text + (".*" if entry.endswith("/") else ""))


class Whitelist:
    def __init__(self, entries):
        patterns = [(pattern(entry), entry) for entry in entries]  # all are texts from here on
        self.rules = [(rule, not entry.startswith("!")) for rule, entry in patterns]
        self.folders = {entry.lstrip("!").split("/")[0] for entry in entries if "/" in entry}

    def names(self, path):
        if ALWAYS.fullmatch(path):
            return True
        named = False
        for rule, gives in self.rules:
            if rule.fullmatch(path):
                named = gives
        return named and not NEVER.search(path)


def read_whitelist(root):
    try:
        entries = json.loads((root / "package.json").read_text(encoding="utf-8"))["files"]
    except OSError as error:
        raise Stop(f"package.json: cannot be read: {error.strerror}") from error
    except json.JSONDecodeError as error:
        raise Stop(f"package.json:{error.lineno}:{error.colno}: is not JSON: {error.msg}") from error
    except (ValueError, RecursionError) as error:
        raise Stop(f"package.json: is not JSON that can be read: {error}") from error
    except (KeyError, TypeError):
        entries = None
    if not isinstance(entries, list):
        raise Stop("package.json: has no list 'files' of what ships, and without one npm packs the whole folder: "
                   "write one")
    return Whitelist(entries)


def shipped(root):
    """The package that the work tree makes."""
    whitelist = read_whitelist(root)
    paths = [path for path in files_below(root, whitelist.folders) if whitelist.names(path)]
    return Package(root, paths, {path: source for path, source in SOURCES.items() if path in paths})
