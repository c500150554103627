"""Results of `penumbra measure`, and figures of their records as the pages' tables show them."""
import functools
import json
import math
import re
from pathlib import Path

from markdown import Problem, table
from results_table import read_table

ROOT = Path(__file__).resolve().parent.parent.parent
DOCUMENTATION = ROOT / "Documentation~"
DOCS = ROOT / "docs"
RESULTS = DOCUMENTATION / "results"
COMMAND = "scripts/pages"

# Student's t, 97.5 %, by degrees of freedom; Abramowitz & Stegun, table 26.10.
STUDENT = (12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131,
           2.120, 2.110, 2.101, 2.093, 2.086)
INTERVALS = ("± is half the width of the 95 % confidence interval over the scenes; where it is cut off at 0 or at the"
             " largest possible value, [a, b] gives its ends")


@functools.cache
def read(study):
    """The results of a study. Their command is scripts/publish, and measured_by is the one that they were measured by:
    names of techniques and options change."""
    results = read_table((RESULTS / study / "results.tsv").read_text())
    return {**results, "command": f"scripts/publish {study}", "measured_by": results["command"]}


def read_json(path):
    return json.loads(path.read_text())


def holds_objects(value):
    """Whether a list of objects is somewhere in it."""
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return (isinstance(value, list) and any(isinstance(each, dict) for each in value)) or any(map(holds_objects, inner))


def json_text(value, indent=""):
    """JSON with each object on a line of its own; one that holds lists of objects has a line for each of its keys."""
    if not holds_objects(value):
        return json.dumps(value)
    deeper = indent + "  "
    keyed = isinstance(value, dict)
    lines = [f"{json.dumps(key)}: {json_text(each, deeper)}" for key, each in value.items()] if keyed else [
        json_text(each, deeper) for each in value]
    opened, closed = "{}" if keyed else "[]"
    return opened + ",".join(f"\n{deeper}{line}" for line in lines) + f"\n{indent}{closed}"


def write_json(path, value):
    path.write_text(json_text(value) + "\n")


def figure(value, digits, scale=1.0):
    return "-" if value is None else f"{scale * value:.{digits}f}"


def mean(values):
    """Of the figures that are there; None without one."""
    there = [value for value in values if value is not None]
    return sum(there) / len(there) if there else None


def with_interval(values):
    """(mean, half width of its 95 % confidence interval) of values, one per scene; None of fewer than two."""
    count = len(values)
    if count < 2:
        return None
    centre = sum(values) / count
    variance = sum((value - centre) ** 2 for value in values) / (count - 1)
    return centre, STUDENT[min(count - 1, len(STUDENT)) - 1] * math.sqrt(variance / count)


def bound(value, digits):
    """An end of an interval; one at a bound of the figure has no decimals, as in the tables that the program writes."""
    return f"{value:g}" if value in (0.0, 1.0, 100.0) else f"{value:.{digits}f}"


def mean_and_interval(values, digits, most=1.0):
    """"0.081 ± 0.018", of the values that are there; the mean alone of one. Where the interval would go below 0 or
    above `most`, which no figure of a scene is, "12.21 [0, 27.11]" has its ends."""
    there = [value for value in values if value is not None]
    interval = with_interval(there)
    if interval is None:
        return figure(mean(there), digits)
    centre, half = interval
    low, high = max(centre - half, 0.0), min(centre + half, most)
    if low > centre - half or high < centre + half:
        return f"{centre:.{digits}f} [{bound(low, digits)}, {bound(high, digits)}]"
    return f"{centre:.{digits}f} ± {half:.{digits}f}"


def against(values, others, digits):
    """"0.153", of the values compared with themselves; "0.114 (-0.039 ± 0.012)" with others, both by scene."""
    pairs = [(value, other) for value, other in zip(values, others) if None not in (value, other)]
    shown = figure(mean(value for value, _ in pairs), digits)
    interval = with_interval([value - other for value, other in pairs])
    if values == others or interval is None:
        return shown
    return f"{shown} ({interval[0]:+.{digits}f} ± {interval[1]:.{digits}f})"


def distinct(records, key):
    return list(dict.fromkeys(record[key] for record in records))


def groups(records, *keys):
    """(values of the keys, their records), by the first key, then the next; combinations without records are left
    out."""
    if not keys:
        yield (), records
        return
    for value in distinct(records, keys[0]):
        for others, own in groups([record for record in records if record[keys[0]] == value], *keys[1:]):
            yield (value, *others), own


def of_key(key):
    """What a record's figure is: by its key, or by a function of the record."""
    return key if callable(key) else lambda record: record[key]


def interval_of(key, digits, most=1.0, scale=1.0):
    """A cell of records: the mean and interval of a figure."""
    def cell(records):
        values = map(of_key(key), records)
        return mean_and_interval([None if value is None else scale * value for value in values], digits, most)
    return cell


def mean_of(key, digits, scale=1.0):
    return lambda records: figure(mean(map(of_key(key), records)), digits, scale)


def part_of(part, key):
    """A figure of a part that not every record has."""
    return lambda record: record[part][key] if part in record else None


def by_light(records, cell, lights=None):
    """The cell of each light's records."""
    return [cell([record for record in records if record["light_degrees"] == light])
            for light in lights or distinct(records, "light_degrees")]


def light_heads(records, what="{} light"):
    return [what.format(f"{light:g}°") for light in distinct(records, "light_degrees")]


def code(name):
    return f"`{name}`"


def all_fetches(record):
    """Of all passes; None where they were not counted."""
    at_full_size = record["fetches_mean"]
    return None if at_full_size is None else at_full_size + record["preprocess_fetches_per_pixel"]


ERROR = interval_of("rmse_penumbra", 3)
ERROR_OF_ALL = interval_of("rmse_all", 3)
FETCHES = interval_of(all_fetches, 1, math.inf)
FETCHES_ALONE = mean_of(all_fetches, 1)
PLAIN = {"RMSE in penumbra": ERROR, "RMSE of all pixels": ERROR_OF_ALL,
         "light leaks, %": interval_of("leak_rate", 2, 100.0, 100.0),
         "false shadow, %": interval_of("false_shadow_rate", 2, 100.0, 100.0), "fetches per pixel": FETCHES}


def made(results):
    """The command of the results, and the commit that they were measured at."""
    commit = results.get("commit") or ""
    if not re.fullmatch("[0-9a-f]{40}", commit):
        raise Problem(f"the results of '{results['command']}' are of commit '{commit}', which nobody can check out:"
                      " measure again from a commit without changes")
    return f"Command: `{results['command']}`, at commit {commit}"


def sample(records):
    """How many scenes, and how many penumbra pixels at least each of them has under each light."""
    scenes = distinct(records, "scene")
    fewest = min(record["penumbra_pixels"] for record in records)
    if len(scenes) == 1:
        return f"{scenes[0]}, at least {fewest} penumbra pixels under each light"
    return f"mean of {len(scenes)} scenes, at least {fewest} penumbra pixels per scene and light; {INTERVALS}"


def scenes(records):
    return f"mean of {len(distinct(records, 'scene'))} scenes; {INTERVALS}"


def measured(results, head, rows, left, what=None, and_so_on=False):
    """A table below what it was measured on, what its figures are of, and the command."""
    what = what or sample(results["records"])
    return (f"{results['device']}, {what}. {made(results)}{', and so on' if and_so_on else ''}.\n\n"
            + table(head, rows, left))


def techniques_by_light(results, head, cell, names=None, title=code):
    """One row per technique, one column per light."""
    records = results["records"]
    rows = [[title(name), *by_light(own, cell)] for (name,), own in groups(records, "technique") if names is None
            or name in names]
    return [head, *light_heads(records)], rows, 1
