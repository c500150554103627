"""Tables of Documentation~/other-shadows.md: volumes, rays through fog, distance fields."""
from figures import (COMMAND, DOCUMENTATION, FETCHES_ALONE, PLAIN, RESULTS, code, distinct, groups, interval_of, made,
                     mean, measured, read,
                     read_json, scenes)
from markdown import Problem, table


def volume_rows(results):
    """One row per light and technique: means over the scenes, with the smallest and the largest."""
    columns = (("rmse_penumbra", 3, 1.0), ("rmse_all", 3, 1.0), ("leak_rate", 2, 100.0),
               ("false_shadow_rate", 2, 100.0))
    rows = []
    for (light, name), own in groups(results["records"], "light_degrees", "technique"):
        def cell(key, digits, scale):
            values = [scale * record[key] for record in own if record[key] is not None]
            return f"{mean(values):.{digits}f} ({min(values):.{digits}f} – {max(values):.{digits}f})"

        rows.append([f"{light:g}°", code(name), *(cell(*column) for column in columns), FETCHES_ALONE(own)])
    count = len(distinct(results["records"], "scene"))
    return measured(results, ["light", "technique", *PLAIN], rows, 2,
                    f"means of {count} scenes, with the smallest and the largest")


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


def only(records, **wanted):
    found = [record for record in records if all(record[key] == value for key, value in wanted.items())]
    if len(found) != 1:
        raise Problem(f"{FIELDS.name} has {len(found)} records of {wanted}, not one")
    return found[0]


def march_errors(results):
    records = results["marches"]
    widths = distinct(records, "width_metres")
    rows = [[shape, MARCHES[march],
             *(f"{only(records, shape=shape, march=march, width_metres=width)['rmse']:.3f}" for width in widths)]
            for shape in distinct(records, "shape") for march in MARCHES]
    return (f"{results['device']}; {min(record['receivers'] for record in records)} receivers in the penumbra or more"
            f" of each shape and"
            f" width, {results['rays']} rays each; fields of {results['voxels']} voxels along 1.2 m. "
            f" \n{made(results)}.\n\n"
            + table(["shape", "march", *(f"{width:g} m" for width in widths)], rows, 2))


def march_fetches(results):
    """Means over the shapes."""
    records = results["marches"]
    widths = distinct(records, "width_metres")
    rows = [[MARCHES[march],
             *(f"{mean(one['fetches'] for one in records if (one['march'], one['width_metres']) == (march, width)):.0f}"
                               for width in widths)] for march in MARCHES]
    return table(["march", *(f"{width:g} m" for width in widths)], rows, 1)


def object_errors(results):
    records = results["objects"]
    rows = [[record["scene"], f"{record['width_metres']:g} m", record["receivers"],
             *(f"{record[way]:.3f}" for way in WAYS)]
            for record in records]
    rows.append(["mean of the rows", "", "", *(f"{mean(record[way] for record in records):.3f}" for way in WAYS)])
    return (f"{results['device']}; fields of 32 voxels along each object's longest side; {results['rays']} rays for"
            f" each receiver.  \n"
            f"{made(results)}.\n\n" + table(["scene", "width", "receivers", *WAYS.values()], rows, 1))


def fields(results):
    return {"march-errors": march_errors(results), "march-fetches": march_fetches(results),
            "object-errors": object_errors(results)}


def parts(_):
    return {DOCUMENTATION / "other-shadows.md": {"shadow-volumes": volume_rows(read("shadow-volumes")),
                                                 "volumetric": volumetric(read_json(RESULTS / "volumetric.json")),
                                                 **fields(read_json(FIELDS))}}
