"""Tables in Markdown pages that are written from JSON files: between `<!-- NAME -->` and `<!-- /NAME -->`."""
import difflib
import sys


class Problem(Exception):
    """The reason why a page cannot be written."""


def table(head, rows, left):
    """`left` columns are text, the others numbers."""
    lines = ["| " + " | ".join(head) + " |", "|" + ":--|" * left + "--:|" * (len(head) - left)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def written(page, parts):
    """The page's text with the parts, a text by name, put into their places."""
    for name, text in parts.items():
        begin, end = f"<!-- {name} -->", f"<!-- /{name} -->"
        if page.count(begin) != 1 or page.count(end) != 1:
            raise Problem(f"the page needs {begin} and {end} once each")
        head, rest = page.split(begin)
        page = head + begin + "\n" + text + "\n" + end + rest.split(end)[1]
    return page


def update(path, parts, command, check):
    """Writes the parts into the page; with `check` ends the program when that would change it."""
    page = path.read_text()
    wanted = written(page, parts)
    if not check:
        path.write_text(wanted)
    elif page != wanted:
        print("\n".join(difflib.unified_diff(page.splitlines(), wanted.splitlines(), "the page", "the JSON files",
                                             lineterm="")))
        sys.exit(f"{path.name} differs from the JSON files: run {command}")
