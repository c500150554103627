"""JSON values with line and column, so that a rule can report where a file violates it."""
import json
from json.decoder import WHITESPACE, scanstring

from .problem import Problem, at_offset


class Malformed(Exception):
    def __init__(self, problem):
        super().__init__(str(problem))
        self.problem = problem


class Document:
    """`value` is the JSON; a place in it is a tuple of keys and indices."""

    def __init__(self, path, text):
        self.path, self.text, self.offsets = path, text, {}
        try:
            self.value = json.loads(text)
            self._place(0, ())
        except json.JSONDecodeError as error:
            raise Malformed(Problem(path, f"is not JSON: {error.msg}", error.lineno, error.colno)) from error
        except ValueError as error:  # a number of too many digits
            raise Malformed(Problem(path, f"is not JSON that can be read: {error}")) from error
        except RecursionError as error:
            raise Malformed(Problem(path, "is JSON nested too deeply to read")) from error

    def problem(self, place, message):
        """At the location, or at its container if it is missing."""
        while place not in self.offsets:
            place = place[:-1]
        return at_offset(self.path, self.text, self.offsets[place], message)

    def _space(self, offset):
        return WHITESPACE.match(self.text, offset).end()

    def _place(self, offset, place):
        """Notes where the value at `offset` begins, and what is in it; returns where it ends."""
        offset = self._space(offset)
        self.offsets[place] = offset
        opening = self.text[offset]
        if opening not in "{[":
            return json.JSONDecoder().raw_decode(self.text, offset)[1]
        index = 0
        offset = self._space(offset + 1)
        while self.text[offset] not in "}]":
            key = index
            if opening == "{":
                key_offset = offset
                key, offset = scanstring(self.text, offset + 1, True)
                if (*place, key) in self.offsets:
                    raise Malformed(at_offset(self.path, self.text, key_offset,
                                              f"the key '{key}' is there twice: remove one"))
                offset = self._space(offset) + 1  # past the colon
            offset = self._space(self._place(offset, (*place, key)))
            if self.text[offset] == ",":
                offset = self._space(offset + 1)
            index += 1
        return offset + 1
