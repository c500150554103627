"""Tables of Documentation~/screen-passes.md."""
import math

from figures import (DOCUMENTATION, ERROR, ERROR_OF_ALL, FETCHES, FETCHES_ALONE, INTERVALS, PLAIN, by_light, code,
                     distinct, figure, groups, interval_of, light_heads, made, mean, mean_of, measured, part_of, read,
                     sample)
from markdown import Problem, table

PAGE = DOCUMENTATION / "screen-passes.md"


def screen_figures(results):
    columns = {"penumbra RMSE": ERROR, "fetches per pixel, all passes": FETCHES,
               "pixels skipped by the mask, %": mean_of(part_of("mask", "pixels_saved"), 0, 100.0),
               "penumbra pixels missed by the mask, %": mean_of(part_of("mask", "penumbra_pixels_missed"), 2, 100.0),
               "shimmer, static noise": mean_of(part_of("shimmer", "static_noise"), 3),
               "shimmer, noise per frame": mean_of(part_of("shimmer", "per_frame_noise"), 3)}
    rows = [[name, *(cell(own) for cell in columns.values())] for (name,),
            own in groups(results["records"], "technique")]
    return measured(results, ["technique", *columns], rows, 1)


EDGE_PASSES = ("MarkSamples", "MarkSurfaces", "ShadePixels", "ShadeSamples", "MeanOfSamples")


def pass_fetches(records, name):
    """Of that pass, per pixel of the picture; None where there is none."""
    return mean(one["fetches_per_pixel"] for record in records for one in record.get("passes", [])
                if one["pass"] == name)


def edges(results):
    """One row per technique and light: errors and fetches at edges alone, paired with those of the first technique that
    shades once for a pixel; and the fetches of each pass over the picture."""
    records = results["records"]
    rows, passes = [], []
    for (degrees, name), own in groups(records, "light_degrees", "technique"):
        rows.append([name, f"{degrees:g}°", ERROR_OF_ALL(own), ERROR(own),
                     interval_of("fetches_mean", 1, math.inf)(own)])
        counts = [pass_fetches(own, one) for one in EDGE_PASSES]
        if any(count is not None for count in counts):
            passes.append([f"{degrees:g}°", *(figure(count, 1) for count in counts)])
    pixels = [record["pixels"] for record in next(groups(records, "light_degrees", "technique"))[1]]
    head = ["technique", "light", "RMSE at edges", "RMSE at edges in penumbra", "fetches per edge pixel"]
    what = f"mean of {len(pixels)} scenes, {sum(pixels)} edge pixels, at least {min(pixels)} per scene; {INTERVALS}"
    return (measured(results, head, rows, 2, what) + "\n\nFetches per pixel of the whole picture, by pass:\n\n"
            + table(["light", *map(code, EDGE_PASSES)], passes, 1))


def with_and_without(*runs):
    """One row per light and technique of each run."""
    rows, notes = [], []
    for results in runs:
        notes += [f"{results['device']}, {sample(results['records'])}.", f"{made(results)}."]
        for (light, name), own in groups(results["records"], "light_degrees", "technique"):
            rows.append([code(name), f"{own[0]['settings']['normal_bias']:g}", f"{light:g}°",
                         *(cell(own) for cell in PLAIN.values())])
    return " ".join(dict.fromkeys(notes)) + "\n\n" + table(["technique", "normal bias", "light", *PLAIN], rows, 1)


TRACE_DEFAULTS = {"traceLengthMetres": 0.5, "traceThicknessMetres": 0.05, "traceSteps": 12}


def trace_settings(results):
    """The technique without a trace, then a row for each setting that is the default or differs from it in one
    value."""
    rows = []
    for _, own in groups(results["records"], "technique"):
        values = {key: own[0]["parameters"][key][0] for key in TRACE_DEFAULTS if key in own[0]["parameters"]}
        if sum(values[key] != TRACE_DEFAULTS[key] for key in values) <= 1:
            rows.append([*(f"{values[key]:g}" if values else "-" for key in TRACE_DEFAULTS),
                         *(cell(own) for cell in PLAIN.values())])
    return measured(results, ["length, m", "thickness, m", "steps", *PLAIN], rows, 0)


HISTORY = "history="  # of a technique's name, where several were measured (`penumbra measure --history`)


def of_history(records, name, share):
    return [record for record in records if record["technique"] == f"{name} {HISTORY}{share:g}"]


def without_history(results):
    """The techniques' names, and the share of the newest frame in the histories that are not single frames."""
    names = distinct(results["records"], "technique")
    shares = {float(name.split(HISTORY)[1]) for name in names} - {1.0}
    if len(shares) != 1:
        raise Problem(f"'{results['command']}' has not one history beside single frames")
    return list(dict.fromkeys(name.split(" " + HISTORY)[0] for name in names)), shares.pop()


def flicker(record):
    """Standard deviation of a penumbra pixel's visibility over the results; root of the mean of squares."""
    return None if record["variance"] is None else math.sqrt(record["variance"])


def plain_title(record):
    return record["title"].split(" " + HISTORY)[0]


def noise_rows(results):
    """One row per technique: the errors of single frames and of the history, and the history's flicker, by light."""
    names, share = without_history(results)
    lights = light_heads(results["records"], "{}")
    rows = []
    for name in names:
        one, many = of_history(results["records"], name, 1.0), of_history(results["records"], name, share)
        rows.append([plain_title(one[0]), *by_light(one, ERROR), *by_light(many, ERROR),
                     *by_light(many, interval_of(flicker, 4)), *by_light(one, FETCHES_ALONE)])
    heads = [f"{what}, {light}" for what in ("RMSE in penumbra", "RMSE in penumbra, history", "flicker, history",
                                             "fetches per pixel") for light in lights]
    return measured(results, ["technique", *heads], rows, 1)


def noise_pan(results):
    """One row per technique: change from frame to frame of a pan, by light."""
    kinds = {"static noise": "static_noise", "noise per frame": "per_frame_noise"}
    rows = [[own[0]["title"], *(shown for key in kinds.values()
                                for shown in by_light(own, interval_of(part_of("shimmer", key), 4)))]
            for _, own in groups(results["records"], "technique")]
    heads = [f"shimmer, {kind}, {light}" for kind in kinds for light in light_heads(results["records"], "{}")]
    return measured(results, ["technique", *heads], rows, 1)


def changes(record):
    """How much penumbrae change in the pan: with static noise, which the techniques without history have."""
    shimmer = record["shimmer"]
    return shimmer["per_frame_noise"] if shimmer["static_noise"] is None else shimmer["static_noise"]


def accumulation(moving, resting):
    """One row per technique, of the mean over frames one in motion and one at rest."""
    columns = {"RMSE in penumbra": ERROR, "grain": interval_of(flicker, 4), "shimmer": interval_of(changes, 4),
               "false shadow, %": interval_of("false_shadow_rate", 2, 100.0, 100.0),
               "operations per pixel": mean_of("operations_per_pixel", 0)}

    def row(own, when=""):
        return [own[0]["title"] + when, *(shown for cell in columns.values() for shown in by_light(own, cell))]

    rows = [row(own, ", in motion" if own[0]["technique"] == resting["records"][0]["technique"] else "")
            for _, own in groups(moving["records"], "technique")]
    rows.insert(1, row(resting["records"], ", at rest"))
    heads = [f"{what}, {light}" for what in columns for light in light_heads(moving["records"], "{}")]
    return measured(moving, ["technique", *heads], rows, 1, and_so_on=True)


def parts(_):
    return {PAGE: {"screen-figures": screen_figures(read("screen-passes")),
                   "edges": edges(read("edges")),
                   "contact-shadows": with_and_without(read("contact-shadows"), read("contact-shadows-urp-bias")),
                   "contact-settings": trace_settings(read("contact-shadow-settings")),
                   "noise": noise_rows(read("noise")),
                   "accumulation": accumulation(read("accumulation"), read("accumulation-at-rest"))}}
