"""The blocks of a study's results: tables of means over its scenes, and how they were measured."""
import studies
from figures import DOCUMENTATION, ROOT, all_fetches, code, distinct, read
from markdown import Problem, table
from result_columns import (ERROR, FALSE_SHADOW, FETCHES, FLIP, GRAIN, GROUP_STEP, LEAKS, OPERATIONS, OVERLAP,
                            PENUMBRA_ERROR, PENUMBRA_FETCHES)
from technique_facts import FAMILY, cost_rows, cycles, known, map_mebibytes


class Shown:
    """The records of a study that a block shows: of all techniques, or of these rows in their order."""

    def __init__(self, results, rows=()):
        self.results = results
        measured = distinct(results["records"], "technique")
        unknown = [row for row in rows if row not in measured]
        if unknown:
            raise Problem(f"'{results['command']}' has not measured {', '.join(unknown)}")
        self.techniques = list(rows) or measured
        self.records = [record for record in results["records"] if record["technique"] in self.techniques]
        places = [[(record["scene"], record["light_degrees"]) for record in self.of(name)] for name in self.techniques]
        if any(sorted(own) != sorted(set(places[0])) for own in places):
            raise Problem(f"'{results['command']}' has not one record of each technique, scene and light")
        self.lights = sorted(set(distinct(self.records, "light_degrees")))
        self.middle = self.lights[len(self.lights) // 2]

    def of(self, technique, light=None):
        return [record for record in self.records
                if record["technique"] == technique and light in (None, record["light_degrees"])]

    def title(self, technique):
        return self.of(technique)[0]["title"]

    def has(self, column):
        """Only optimised bytecode counts as operations: before, they say little of what a GPU runs."""
        return (column is not OPERATIONS or "front_end" in self.results) and any(
            column.figure(record) is not None for record in self.records)

    def has_map_passes(self):
        return any(map(map_passes, self.records))

    def sample(self, light):
        """The penumbra pixels of each scene that has some."""
        return {record["scene"]: record["penumbra_pixels"] for record in self.records
                if record["light_degrees"] == light and record["penumbra_pixels"]}

    def picture_sizes(self):
        sizes = sorted({(frame["width"] * frame["height"], f"{frame['width']} x {frame['height']}")
                        for frame in self.results["frames"]})
        return " to ".join(dict.fromkeys((sizes[0][1], sizes[-1][1])))


def map_passes(record):
    return [one for one in record.get("passes", []) if one.get("fetches_per_cascade") is not None]


def counted(count, noun):
    return f"{count} {noun}{'' if count == 1 else 's'}"


def samples(shown):
    texts = []
    for light in shown.lights:
        pixels = shown.sample(light).values()
        least = f", at least {min(pixels)} per scene" if len(pixels) > 1 else ""
        texts.append(f"{light:g}° light, {counted(len(pixels), 'scene')}, {sum(pixels)} penumbra pixels{least}")
    return "; ".join(texts) + ":"


def how_to_read(shown, is_full):
    one = len(distinct(shown.records, "scene")) == 1
    text = ("Errors and rates are measured against ray tracing. Each figure is "
            + ("of one scene" if one else "a mean over the scenes")
            + " ± half the width of its 95 % confidence interval, which covers the choice of "
            + ("pixels and says nothing of other scenes" if one else "scenes and of pixels")
            + "; where the interval is cut off at 0 or 100 %, [a, b] gives its ends. Light leaks: share of the pixels in"
              " full shadow whose visibility is above 0.1. False shadow: share of the fully lit pixels whose visibility"
              " is below 0.9.")
    if shown.has(OVERLAP):
        text += " Shadows overlap where the highest caster over a receiver is four times as far away as the lowest."
    if shown.has(FLIP):
        text += (" FLIP (Andersson et al. 2020): how much the picture lit by these shadows differs from the one lit by"
                 " ray-traced ones for an eye that flips between them, 0 to 1.")
    if shown.has(GRAIN):
        text += " Grain: the root of the mean variance between pictures of different noise, in penumbra."
    if is_full and shown.has(GROUP_STEP):
        text += (" Step across tiles: the step of the error between neighbours on both sides of a border of 8 x 8"
                 " pixels, as a multiple of that between other neighbours.")
    if is_full or not shown.has(OPERATIONS):
        text += (" Fetches in penumbrae: fetches per pixel over the pixels in penumbra alone, where a technique that can"
                 " stop early does all its work; of techniques with passes over the screen, over the whole picture.")
    if shown.has_map_passes():
        text += (" Fetches and operations include the passes over the shadow map, divided by the pixels of the pictures,"
                 f" which are of {shown.picture_sizes()} pixels.")
    if shown.has(OPERATIONS):
        text += (" Operations: scalar arithmetic that all passes execute as FXC has optimised it, per pixel of the"
                 " picture.")
    return text


def provenance(run):
    """Of results, or of the run that measured some of their rows earlier."""
    packages = [f", {package['name']} {package['version']}" for package in run["packages"]]
    return f"Penumbra {run['library_version']} at commit {run['commit']}{''.join(packages)}"


def how_measured(results):
    texts = [f"Command: {code(results['command'])}. {provenance(results)}, shaders compiled by"
             f" {results.get('front_end', 'glslang')}, on {results['device']}, driver {results['driver']}, processor"
             f" {results['hardware']}."]
    texts += [f"Of the same pictures, by {provenance(run)}: {', '.join(map(code, run['techniques']))}. Command:"
              f" {code(run['command'])}." for run in results.get("earlier", [])]
    return "\n\n".join(texts)


def by_light(shown, column, lights=None):
    """(head, cells) of the figure under each light: a cell for each technique."""
    for light in lights or shown.lights:
        yield (column.head + (f", {light:g}°" if len(shown.lights) > 1 else ""),
               [column.cell(shown.of(technique, light)) for technique in shown.techniques])


def rows_of(first, columns, texts_at_end=0):
    """A table of (head, cells) of each column, behind the first."""
    heads, cells = zip(("Technique", first), *columns)
    return table(heads, zip(*cells), 1, texts_at_end)


def brief_columns(shown):
    columns = [PENUMBRA_ERROR, ERROR, LEAKS, FALSE_SHADOW]
    if len(shown.lights) == 1:
        return [*columns, FETCHES, PENUMBRA_FETCHES]
    columns += filter(shown.has, (OVERLAP, FLIP, GRAIN))
    return [*columns, OPERATIONS if shown.has(OPERATIONS) else FETCHES]


def brief(shown):
    """One table."""
    columns = [each for column in brief_columns(shown) for each in by_light(shown, column)]
    return (f"{samples(shown)}\n\n{rows_of(map(shown.title, shown.techniques), columns)}\n\n"
            f"{how_to_read(shown, False)}  \n{how_measured(shown.results)}")


def map_pass_figures(records):
    """(fetches of the passes over the map, which do not depend on the picture's size; the others per pixel): means over
    the scenes."""
    there = [record for record in records if all_fetches(record) is not None and map_passes(record)]
    if not there:
        return "–", "–"
    of_map = sum(one["fetches_per_cascade"] * record["cascades"] for record in there for one in map_passes(record))
    others = sum(all_fetches(record) - sum(one["fetches_per_pixel"] for one in map_passes(record)) for record in there)
    return f"{of_map / len(there) / 1e6:.1f}", f"{others / len(there):.1f}"


def facts(shown):
    """(what the columns mean, the columns, how many of them are text)."""
    text = ("Maps: the shadow map and the textures that are made of it, without those of the picture's size. Cycles: a"
            " compiler's static estimate per 64 threads, of the program that gives the visibility + of its other passes;"
            " it assumes eight iterations of every loop, however many samples a technique takes.")
    maps = [f"{map_mebibytes(shown.of(name)[0], known().textures(name)):.1f}" for name in shown.techniques]
    counts = [cycles(name, known().visibility_entry(name), cost_rows()) for name in shown.techniques]
    columns = [("maps, MiB", maps), (f"cycles, RADV, {FAMILY}", counts)]
    advice = list(zip(*map(known().advice, shown.techniques)))
    if not any(map(any, advice)):
        return text, columns, 0
    return (text + " When to use it: the library's advice, from its own measurements and not from the figures here.",
            [*columns, *zip(("Use it when", "Not when"), advice)], 2)


def costs(shown):
    """One row for each technique: the error of all pixels, what it costs, and what is known of it."""
    columns = [each for column in filter(shown.has, (ERROR, OVERLAP, FLIP, GRAIN, GROUP_STEP, FETCHES))
               for each in by_light(shown, column)]
    columns += by_light(shown, PENUMBRA_FETCHES, [shown.middle])
    if shown.has(OPERATIONS):
        columns += by_light(shown, OPERATIONS)
    if shown.has_map_passes():
        columns += zip(("fetches of the passes over the map, millions", "other fetches per pixel"),
                       zip(*(map_pass_figures(shown.of(name, shown.middle)) for name in shown.techniques)))
    explained, known_columns, texts = facts(shown)
    return explained + "\n\n" + rows_of(map(code, shown.techniques), columns + known_columns, texts)


def full(shown, chart):
    """A table of errors, the chart, and a table of costs."""
    errors = [each for column in (PENUMBRA_ERROR, LEAKS, FALSE_SHADOW) for each in by_light(shown, column)]
    names = [f"{shown.title(name)}, {code(name)}" for name in shown.techniques]
    return (f"{how_to_read(shown, True)}\n\n{samples(shown)}\n\n{rows_of(names, errors)}\n\n"
            f"![Penumbra error against fetches per pixel]({chart})\n\n{costs(shown)}\n\n{how_measured(shown.results)}")


def line(shown):
    """One sentence: penumbra RMSE and fetches under the middle light; units are given once."""
    texts = []
    for name in shown.techniques:
        error, fetches, in_penumbra = (column.cell(shown.of(name, shown.middle))
                                       for column in (PENUMBRA_ERROR, FETCHES, PENUMBRA_FETCHES))
        units = ("", "") if texts else (" texture fetches per pixel", " per pixel in penumbra")
        texts.append(f"{shown.title(name)}: {error} with {fetches}{units[0]} ({in_penumbra}{units[1]})")
    return (f"Error in penumbrae (RMSE of visibility, 0 to 1, against ray tracing; {shown.middle:g}° light, mean of"
            f" {counted(len(shown.sample(shown.middle)), 'scene')}): {'; '.join(texts)}.")


def parts(_program):
    pages = {ROOT / "README.md": {"line": line(Shown(read("presets"), studies.HEADLINE))}}
    for study, page in studies.FULL.items():
        shown = Shown(read(study), studies.ROWS.get(study, ()))
        pages.setdefault(DOCUMENTATION / page, {})[study] = full(shown, f"results/{study}/pareto-fetches.svg")
    for study, page in studies.BRIEF.items():
        pages.setdefault(DOCUMENTATION / page, {})[study] = brief(Shown(read(study), studies.ROWS.get(study, ())))
    return pages
