"""Tables in Markdown pages: between `<!-- NAME -->` and `<!-- /NAME -->`."""
import difflib


class Problem(Exception):
    """The reason why a page cannot be written."""


def table(head, rows, left, right=0):
    """The `left` first and the `right` last columns are text, the others numbers."""
    lines = ["| " + " | ".join(head) + " |",
             "|" + ":--|" * left + "--:|" * (len(head) - left - right) + ":--|" * right]
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


def differences(name, before, after):
    return "\n".join(difflib.unified_diff(before.splitlines(), after.splitlines(), name, "its results", lineterm=""))
