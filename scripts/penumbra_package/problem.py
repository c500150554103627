"""A problem of a package, with its location, and what to do about it in the text."""
from typing import NamedTuple


class Problem(NamedTuple):
    path: str
    text: str
    line: int = 0  # from 1; 0 for the file as a whole
    column: int = 0

    def __str__(self):
        place = f":{self.line}:{self.column}" if self.line else ""
        return f"{self.path}{place}: {self.text}"


class Stop(Exception):
    """Ends the program; `code` is 1 for violated rules, 2 for bad input, 3 for a missing tool."""

    def __init__(self, text, code=2):
        super().__init__(text)
        self.code = code


def at_offset(path, text, offset, message):
    """A problem at an offset of a file's text."""
    line_start = text.rfind("\n", 0, offset) + 1
    return Problem(path, message, text.count("\n", 0, offset) + 1, offset - line_start + 1)
