"""Tables of Documentation~/pipelines.md."""
import math

from figures import (DOCUMENTATION, ERROR, FETCHES, against, code, groups, made, mean_and_interval, mean_of, measured,
                     part_of, read, sample)
from markdown import Problem, table


def by_setting(records, setting):
    """{(technique, value): its records in the order of the scenes}, of "pcss-24 light-fit=receivers", and the first
    value."""
    found = {}
    for (title,), own in groups(records, "technique"):
        name, mark, value = title.partition(f" {setting}=")
        if not mark:
            raise Problem(f"'{title}' does not say its {setting}")
        found[name, value] = own
    return found, next(iter(found))[1]


def densities(record):
    """Logarithm of the shadow map's texels per metre, mean over the pixels that read it."""
    read = [(cascade["pixels"], cascade["texel_size_metres"]) for cascade in record["per_cascade"] if cascade["pixels"]]
    return -sum(pixels * math.log(size) for pixels, size in read) / sum(pixels for pixels, _ in read)


def light_fits(results):
    """One row per technique and fit, a table per light; differences to the first fit, paired by scene."""
    tables = []
    for (light,), records in groups(results["records"], "light_degrees"):
        fits, first = by_setting(records, "light-fit")
        rows = []
        for (technique, fit), own in fits.items():
            base = fits[technique, first]
            gains = [math.exp(densities(record) - densities(other)) for record, other in zip(own, base)]
            rows.append([technique, fit, "1" if own is base else mean_and_interval(gains, 2, math.inf),
                         *(against([record[key] for record in own], [record[key] for record in base], 3)
                           for key in ("rmse_penumbra", "rmse_all", "leak_rate", "false_shadow_rate"))])
        head = ["technique", "fit", "texels per metre, relative", "RMSE in penumbra", "RMSE of all pixels",
                "light leaks, share",
                "false shadow, share"]
        tables.append(f"{light:g}° light, {sample(records)}:\n\n{table(head, rows, 2)}")
    return f"{results['device']}. {made(results)}.\n\n" + "\n\n".join(tables)


def cascade_blends(results):
    """One row per technique and blend."""
    records = results["records"]
    blends, _ = by_setting(records, "cascade-blend")
    columns = {"step at the border": mean_of(part_of("seam", "step"), 4),
               "step elsewhere": mean_of(part_of("seam", "elsewhere"), 4),
               "RMSE in penumbra": ERROR, "RMSE of all pixels": mean_of("rmse_all", 3), "fetches per pixel": FETCHES}
    rows = [[*title, *(cell(own) for cell in columns.values())] for title, own in blends.items()]
    pairs = sum(record["seam"]["pairs"] for record in next(iter(blends.values())))
    return measured(results, ["technique", "blend", *columns], rows, 2,
                    f"{sample(records)}; {pairs} pairs of pixels at the borders of all scenes")


AGED = "pcss-angular-24-16"


def map_ages(results):
    """One row per age, of PCSS: the error in penumbrae, by cascade and of all, as growth against a map of now."""
    records = results["records"]
    ages, first = by_setting([record for record in records if record["technique"].startswith(AGED)], "map-age")
    cascades = range(max(len(record["per_cascade"]) for record in records))
    columns = [*(lambda record, i=i: record["per_cascade"][i]["rmse_penumbra"] for i in cascades),
               lambda record: record["rmse_penumbra"]]
    rows = [[age, *(against(list(map(of, own)), list(map(of, ages[technique, first])), 3) for of in columns)]
            for (technique, age), own in ages.items()]
    head = [f"age, degrees, of {code(AGED)}", *(f"RMSE in penumbra, cascade {i}" for i in cascades), "all cascades"]
    return measured(results, head, rows, 1)


def parts(_):
    return {DOCUMENTATION / "pipelines.md": {"light-fits": light_fits(read("light-fit")),
                                             "cascade-blends": cascade_blends(read("cascade-blend")),
                                             "map-ages": map_ages(read("map-age"))}}
