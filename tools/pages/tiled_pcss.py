"""Tables of Documentation~/tiled-pcss.md."""
import math

from figures import (DOCUMENTATION, ERROR, RESULTS, against, by_light, code, distinct, groups, interval_of,
                     light_heads, made, mean, measured, of_key, part_of, read, read_json, sample)
from markdown import Problem, table
from screen_passes import noise_pan

PCSS, MANY_SAMPLES = "screen-pcss-angular-24-16", "pcss-angular-64-64"


def same_order(records, others):
    """The others' records in the order of the records' scenes."""
    by_scene = {record["scene"]: record for record in others}
    return [by_scene[record["scene"]] for record in records]


def of_light(records, like):
    return [record for record in records if record["light_degrees"] == like[0]["light_degrees"]]


def share_of(key, others):
    """A cell of records: the mean over the scenes of a figure, as a share of the others' mean."""
    def cell(records):
        return f"{mean(one[key] for one in records) / mean(one[key] for one in of_light(others, records)):.2f}"
    return cell


def difference_from(key, others, digits):
    """A cell of records: the mean, and in parentheses its difference from the others', paired by scene."""
    def cell(records):
        paired = same_order(records, of_light(others, records))
        return against([of_key(key)(one) for one in records], [of_key(key)(one) for one in paired], digits)
    return cell


def beside_pcss(results, error="rmse_penumbra", what="RMSE in penumbra"):
    """Errors beside those of PCSS with many samples, and operations beside those of PCSS 24+16: one row per
    technique."""
    own = {name: records for (name,), records in groups(results["records"], "technique")}
    if not {PCSS, MANY_SAMPLES} <= set(own):
        raise Problem(f"the results lack {PCSS} or {MANY_SAMPLES}, which the others are compared with")
    rows = [[code(name), *by_light(records, difference_from(error, own[MANY_SAMPLES], 4)),
             *by_light(records, share_of("operations_per_pixel", own[PCSS]))] for name, records in own.items()]
    head = ["technique", *light_heads(results["records"], what + ", {}"),
            *light_heads(results["records"], "operations, {}")]
    return measured(results, head, rows, 1)


PASS_COUNTS = {"operations": ("operations_per_pixel", 0), "fetches": ("fetches_per_pixel", 2),
               "bytes read": ("bytes_read_per_pixel", 1), "bytes written": ("bytes_written_per_pixel", 2),
               "dispatches": ("dispatches", 0), "groups": ("groups", 0), "barriers per group": ("barriers_per_group", 0)}


def passes_of(results, technique, light):
    """What each pass of a technique does under one light, per pixel of the picture: means over the scenes."""
    records = [one for one in results["records"] if one["technique"] == technique and one["light_degrees"] == light]
    if not records or any("bytes_read_per_pixel" not in one for record in records for one in record["passes"]):
        raise Problem(f"the results lack the passes of {technique}: measure again")
    rows = [[code(name)] + [f"{mean(one[key] for one in passes):,.{digits}f}" for key, digits in PASS_COUNTS.values()]
            for (name,), passes in groups([one for record in records for one in record["passes"]], "pass")]
    head = ["pass", *(f"{what} per pixel" if key.endswith("_per_pixel") else what
                      for what, (key, _) in PASS_COUNTS.items())]
    return measured(results, head, rows, 1, f"{code(technique)} under {light:g}°, mean of {len(records)} scenes")


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
    return {DOCUMENTATION / "tiled-pcss.md": {
        "tiled-pcss-beside-pcss": beside_pcss(read("tiled-pcss-full-hd")),
        "tiled-pcss-passes": passes_of(read("tiled-pcss-full-hd"), "preset-medium", 2.0),
        "tiled-pcss-samples": beside_pcss(read("tiled-pcss-samples")),
        "tiled-pcss-overlap-differences": beside_pcss(read("tiled-pcss-overlaps"), part_of("overlap", "rmse"),
                                                      "RMSE where shadows overlap"),
        "tiled-pcss-pan": noise_pan(read("tiled-pcss-pan")),
        "gpu-times": times_of_gpu(read("gpu-times/1920x1080")),
        "gpu-times-4k": times_of_gpu(read("gpu-times/3840x2160")),
        "texel-errors": texel_errors(texels, "penumbra")}}
