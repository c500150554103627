"""Tables of Documentation~/other-shadows.md: volumes, rays through fog, distance fields."""
from figures import (COMMAND, DOCUMENTATION, FETCHES_ALONE, PLAIN, RESULTS, by_light, code, distinct, groups, interval_of,
                     light_heads, made, mean, measured, read, read_json, scenes)
from markdown import Problem, table


def volume_rows(results):
    """One row per technique: means over the scenes by light, with the smallest and the largest."""
    columns = (("rmse_penumbra", 3, 1.0), ("rmse_all", 3, 1.0), ("leak_rate", 2, 100.0),
               ("false_shadow_rate", 2, 100.0))

    def cell(key, digits, scale):
        def of(own):
            values = [scale * record[key] for record in own if record[key] is not None]
            return f"{mean(values):.{digits}f} ({min(values):.{digits}f} – {max(values):.{digits}f})"
        return of

    rows = [[code(name), *(shown for column in columns for shown in by_light(own, cell(*column))), FETCHES_ALONE(own)]
            for (name,), own in groups(results["records"], "technique")]
    lights = light_heads(results["records"], "{}")
    *figures, fetches = PLAIN
    count = len(distinct(results["records"], "scene"))
    return measured(results, ["technique", *(f"{what}, {light}" for what in figures for light in lights), fetches],
                    rows, 1, f"means of {count} scenes, with the smallest and the largest")


def volumetric(results):
    """One row per density of the fog and number of samples: the error of pixels and of blocks of them, with samples
    at the same places of every ray and with places moved by noise."""
    records = results["records"]
    rows = []
    for (extinction, samples), own in groups(records, "extinction_per_metre", "samples"):
        ways = {jittered: some for (jittered,), some in groups(own, "jittered")}
        rows.append([f"{extinction:g}", samples,
                     *(interval_of(key, 3)(ways[jittered]) for key in ("rmse", "rmse_of_blocks")
                                                   for jittered in (False, True))])
    block = f"{results['block_pixels']} × {results['block_pixels']}"
    (width, height), (texels, more) = results["picture"], results["map"]
    head = ["extinction per metre", "samples", "RMSE of pixels, same places", "moved by noise",
            f"RMSE of means of {block} pixels, same places", "moved by noise"]
    return (f"{results['device']}; scenes {', '.join(distinct(records, 'scene'))} at {width} × {height} pixels,"
            f" {results['cascades']}"
            f" cascades in a map of {texels} × {more} texels, view rays of up to {results['longest_ray_metres']:g} m;"
            f" the answer"
            f" is the mean over {results['places_of_the_exact_answer']} traced rays to the sun's centre from each view"
            f" ray."
            f" {scenes(records).replace('mean of', 'Means of')}.  \n"
            f"{made({**results, 'command': results['command'] + '; ' + COMMAND})}.\n\n{table(head, rows, 0)}")


FIELDS = RESULTS / "distance-fields.json"
MARCHES = {"Quilez": "Quilez 2010", "Aaltonen": "Aaltonen 2018", "QuilezInner": "Quilez, inner penumbra",
           "Cone": "`FieldConeVisibility`", "Soft": "`FieldSoftVisibility`"}
WAYS = {"product": "product", "minimum": "minimum", "sum": "sum of what is covered",
        "product_of_parts": "product of each part",
        "minimum_of_parts": "minimum of each part", "sum_of_parts": "sum of each part"}


def march_errors(results):
    """One row per march: means over the shapes, the smallest and the largest, and fetches, by the penumbra's width."""
    records = results["marches"]
    widths = distinct(records, "width_metres")

    def of(march, width, key):
        found = [one for one in records if (one["march"], one["width_metres"]) == (march, width)]
        if sorted(one["shape"] for one in found) != sorted(distinct(records, "shape")):
            raise Problem(f"{FIELDS.name} has not one record of {march} at {width} m for each shape")
        return [one[key] for one in found]

    rows = [[title, *(f"{mean(errors):.3f} ({min(errors):.3f} – {max(errors):.3f})"
                      for errors in (of(march, width, "rmse") for width in widths)),
             *(f"{mean(of(march, width, 'fetches')):.0f}" for width in widths)] for march, title in MARCHES.items()]
    return (f"{results['device']}; means over {len(distinct(records, 'shape'))} shapes, with the smallest and the largest;"
            f" {min(record['receivers'] for record in records)} receivers in the penumbra or more of each shape and"
            f" width, {results['rays']} rays each; fields of {results['voxels']} voxels along 1.2 m."
            f" {made(results)}.\n\n"
            + table(["march", *(f"{what} {width:g} m" for what in ("RMSE,", "fetches,") for width in widths)], rows, 1))


def object_errors(results):
    """One row per width of the penumbra: means over the scenes."""
    rows = [[f"{width:g} m", sum(record["receivers"] for record in own),
             *(f"{mean(record[way] for record in own):.3f}" for way in WAYS)]
            for (width,), own in groups(results["objects"], "width_metres")]
    return (f"{results['device']}; means over {len(distinct(results['objects'], 'scene'))} scenes; fields of 32 voxels"
            f" along each object's longest side; {results['rays']} rays for each receiver. "
            f"{made(results)}.\n\n" + table(["width", "receivers", *WAYS.values()], rows, 0))


def fields(results):
    return {"march-errors": march_errors(results), "object-errors": object_errors(results)}


def parts(_):
    return {DOCUMENTATION / "other-shadows.md": {"shadow-volumes": volume_rows(read("shadow-volumes")),
                                                 "volumetric": volumetric(read_json(RESULTS / "volumetric.json")),
                                                 **fields(read_json(FIELDS))}}
