"""Tables of Documentation~/cell-pcss.md."""
import math

from figures import (DOCUMENTATION, ERROR, RESULTS, by_light, code, distinct, groups, interval_of, light_heads, made,
                     mean_and_interval, measured, read, read_json, sample, scenes)
from markdown import Problem, table
from screen_passes import noise_pan


def cycles_of_programs(cost, family, technique):
    """Cycles of 64 lanes by program, of the variant for a map in which near is 1."""
    return {row["entry"]: row["figures"]["inverse_throughput_cycles"] for row in cost["rows"]
            if row["family"] == family
            and any(variant["technique"] == technique and "UNITY_REVERSED_Z" in variant["keywords"]
                    for variant in row["variants"])}


def cycles_per_pixel(record, programs):
    """A filter alone is one program, which runs once for each pixel."""
    passes = record.get("passes") or [{"pass": program, "invocations_per_pixel": 1.0} for program in programs]
    missing = [of["pass"] for of in passes if of["pass"] not in programs or "invocations_per_pixel" not in of]
    if missing or not programs:
        raise Problem(f"the cost of {record['technique']} lacks {', '.join(missing) or 'a program'}; measure both"
                      f" again")
    return sum(of["invocations_per_pixel"] * programs[of["pass"]] / 64 for of in passes)


FAMILIES = ("polaris10", "navi21")  # of which the others differ little


def weighted_costs(results, cost):
    """The compiler's cycles per pixel, each pass weighted by the threads that it has: one row per family and technique;
    then operations that are executed."""
    of_cost = {variant["technique"] for row in cost["rows"] for variant in row["variants"]}
    techniques = {name: own for (name,), own in groups(results["records"], "technique") if name in of_cost}
    rows = []
    for family in FAMILIES:
        for name, own in techniques.items():
            programs = cycles_of_programs(cost, family, name)
            rows.append([f"cycles, {family}", code(name),
                         *by_light(own, interval_of(lambda record: cycles_per_pixel(record, programs), 0, math.inf))])
    rows += [["operations of bytecode", code(name), *by_light(own, interval_of("operations_per_pixel", 0, math.inf))]
             for name, own in techniques.items()]
    return (f"{cost['driver']}, {scenes(results['records'])}. "
            f"Command of the cycles: `{cost['command']}`. "
            f"Of the threads and operations: {made(results).removeprefix('Command: ')}.\n\n"
            + table(["per pixel", "technique", *light_heads(results["records"])], rows, 2))


def figures_of_passes(results, technique, key, head):
    """A figure of each pass of the technique: one row per pass; means over the scenes."""
    records = [record for record in results["records"] if record["technique"] == technique]

    def cell(name):
        return lambda own: mean_and_interval([of[key] for record in own for of in record["passes"]
                                              if of["pass"] == name], 3, math.inf)

    return table([head, *light_heads(records)],
                 [[code(name), *by_light(records, cell(name))] for name in distinct(records[0]["passes"], "pass")], 1)


def times_of_passes(results, technique):
    """Milliseconds of a GPU, waits for the passes before included."""
    return figures_of_passes(results, technique, "time_ms_median", f"pass of `{technique}`, ms")


def times_of_gpu(results):
    """Milliseconds beside the errors and false shadow: one row per technique; means over the scenes."""
    records = results["records"]
    if distinct(records, "time_kind") != ["GPU time"] or any(record["time_ms_median"] is None for record in records):
        raise Problem("these are not times of a GPU: measure with --device and --timing-repeats")
    columns = {"ms": interval_of("time_ms_median", 2, math.inf), "RMSE in penumbra": ERROR,
               "false shadow, %": interval_of("false_shadow_rate", 1, 100.0, 100.0)}
    rows = [[code(name), *(shown for cell in columns.values() for shown in by_light(own, cell))]
            for (name,), own in groups(records, "technique")]
    head = ["technique", *(head for what in columns for head in light_heads(records, what + ", {} light"))]
    return measured(results, head, rows, 1, f"GPU time, {sample(records)}")


TEXEL_ESTIMATORS = {
    "bilinear": "bilinear, 2 x 2",
    "disc": "disc over the squares of the texels, smallest radius {floor:g}",
    "shipped": "kernel of `pcss-angular-24-16`, `minFilterTexels` {floor:g}",
    "edge": "straight edge fitted to 4 x 4",
    "mean edge": "mean of the edges that 4 x 4 allow",
    "revectorised 4 x 4": "revectorized from 4 x 4, smallest radius {floor:g}",
    "revectorised 16 x 16": "revectorized from 16 x 16, smallest radius {floor:g}",
    "learned of its kind": "learned for each pattern of 4 x 4, from such shapes",
    "learned": "learned for each pattern of 4 x 4, from all shapes",
    "learned everywhere": "the same, from receivers outside of penumbrae, too"}
TEXEL_FLOORS = ("disc", "shipped")  # of which the best smallest radius is looked for
class TexelErrors:
    """(error, half its interval) by estimator and smallest radius, a column for each radius of the light's disc and
    kind of shapes."""

    def __init__(self, results, figure):
        self.records = {}
        for record in results["records"]:
            key = (record["radius_texels"], record["shapes"]), record["estimator"], record.get("floor_texels")
            if key in self.records:
                raise Problem(f"texel-edges.json has two records of {key}")
            self.records[key] = record[f"rmse_{figure}"], record[f"half_{figure}"]
        self.columns = sorted(dict.fromkeys(key[0] for key in self.records), key=lambda column: column[0])
        self.estimators = list(dict.fromkeys(key[1:] for key in self.records))
        self.head = [f"{radius:g} {shapes}" for radius, shapes in self.columns]

    def best(self, column, estimator):
        """The error with the best smallest radius."""
        return min(self.of(column, *one) for one in self.estimators if one[0] == estimator)

    def of(self, column, estimator, floor):
        if (column, estimator, floor) not in self.records:
            raise Problem(f"texel-edges.json has no {estimator} {floor} of {column}")
        return self.records[column, estimator, floor]


def texel_title(estimator, floor):
    return TEXEL_ESTIMATORS[estimator].format(floor=floor or 0.0)


def texel_errors(results, figure):
    """One row per estimator; of those with several smallest radii the least error of a column is bold. figure:
    penumbra or all."""
    errors = TexelErrors(results, figure)

    def shown(column, estimator, floor):
        error = f"{errors.of(column, estimator, floor)[0]:.3f}"
        is_least = estimator in TEXEL_FLOORS and error == f"{errors.best(column, estimator)[0]:.3f}"
        return f"**{error}**" if is_least else error

    rows = [[texel_title(*one), *(shown(column, *one) for column in errors.columns)] for one in errors.estimators]
    widest = max(half for _, half in errors.records.values())
    fewest = min(record["receivers_penumbra"] for record in results["records"])
    counts = (f"at least {fewest} of them in each column" if figure == "penumbra" else
              f"{results['receivers']} of each kind")
    return (f"Receivers: {counts}; learned from {results['trained']} others of each kind. Half the width of a 95 %"
            f" confidence interval"
            f" is {math.ceil(1e4 * widest) / 1e4:.4f} at most."
            f" {made(results)}.\n\n{table(['estimator', *errors.head], rows, 1)}")


def parts(_):
    texels = read_json(RESULTS / "texel-edges.json")
    at_full_hd = read("cell-pcss-gpu-times/1920x1080")
    return {DOCUMENTATION / "cell-pcss.md": {
        "cell-pcss-pan": noise_pan(read("cell-pcss-pan")),
        "cell-pcss-cycles": weighted_costs(read("cell-pcss-operations"), read_json(RESULTS / "cell-pcss-cost.json")),
        "cell-pcss-gpu-times": times_of_gpu(at_full_hd),
        "cell-pcss-gpu-passes": times_of_passes(at_full_hd, "cell-pcss"),
        "cell-pcss-gpu-times-4k": times_of_gpu(read("cell-pcss-gpu-times/3840x2160")),
        "texel-errors": texel_errors(texels, "penumbra")}}
