"""Reads results.tsv of `penumbra measure`: tools/base/input/json_table.h says what its lines are."""
import functools
import json


@functools.lru_cache(maxsize=None)
def value_of(cell):
    try:
        return json.loads(cell)
    except json.JSONDecodeError:
        return cell


@functools.lru_cache(maxsize=None)
def keys_of(path):
    return [key.replace("~1", "/").replace("~0", "~") for key in path.split("/")]


def nested(values):
    """The object whose parts have these paths: {"a/0": 1} is {"a": [1]}."""
    result = {}
    for path, value in values.items():
        *parents, name = keys_of(path)
        place = result
        for parent in parents:
            place = place.setdefault(parent, {})
        place[name] = value
    return with_lists(result)


def with_lists(value):
    if not isinstance(value, dict):
        return value
    parts = {key: with_lists(part) for key, part in value.items()}
    return [parts[str(index)] for index in range(len(parts))] if "0" in parts else parts


def read_table(text):
    """The same dictionary as results.json holds, with fewer digits of figures."""
    lines = text.removesuffix("\n").split("\n")
    head = [line[1:] for line in lines if line.startswith("#")]
    names, *rows = [line.split("\t") for line in lines[len(head):]]
    results = json.loads("\n".join(head))
    shared = results["records"]
    results["records"] = [
        nested({**shared, **{name: value_of(cell) for name, cell in zip(names, row) if cell != ""}}) for row in rows]
    return results
