"""Tables of Documentation~/far-shadows.md."""
import math

from figures import DOCUMENTATION, FETCHES_ALONE, all_fetches, code, distinct, figure, groups, made, read
from markdown import table

SIZES = (128, 256, 512, 1024)
AZIMUTHS = (0, 11.25, 22.5, 33.75, 45)


def rings_beyond(record):
    """Of `by_distance`, those beyond the shadow distance."""
    return [ring for ring in record["by_distance"] if ring["from_metres"] >= record["by_distance"][1]["to_metres"]]


def beyond(record):
    """The error of the pixels beyond the shadow distance, from those of its rings; None without any."""
    rings = [ring for ring in rings_beyond(record) if ring["rmse_all"] is not None]
    pixels = sum(ring["pixels"] for ring in rings)
    return math.sqrt(sum(ring["pixels"] * ring["rmse_all"] ** 2 for ring in rings) / pixels) if pixels else None


def far_distances(results):
    """The error of all pixels by distance from the camera, one row per scene and technique."""
    rings = results["records"][0]["by_distance"]
    head = ["scene", "technique", *(f"{ring['from_metres']:g} to {ring['to_metres']:g} m" for ring in rings),
            "light leaks, %", "false shadow, %", "fetches per pixel", "bakes, MiB"]
    rows = []
    for (scene,), own in groups(results["records"], "scene"):
        rows.append([code(scene), "pixels", *(ring["pixels"] for ring in own[0]["by_distance"]), "", "", "", ""])
        rows += [[code(scene), record["title"], *(figure(ring["rmse_all"], 3) for ring in record["by_distance"]),
                  figure(record["leak_rate"], 1, 100.0), figure(record["false_shadow_rate"], 1, 100.0),
                  figure(all_fetches(record), 1), figure(record.get("baked_mebibytes"), 1)] for record in own]
    return (f"{results['device']}; one picture of each scene, one seed of the noise. {made(results)}.\n\n"
            + table(head, rows, 2))


def far_steps(results, worst):
    """The error beyond the shadow distance and the fetches of the height-field trace, one row per number of steps; of
    the scenes, and of the azimuth where the trace is worst."""
    scenes = [*map(code, distinct(results["records"], "scene")), "at the worst azimuth"]
    at_worst = [own for _, own in groups(worst["records"], "technique")]
    rows = []
    for (_, own), others in zip(groups(results["records"], "technique"), at_worst, strict=True):
        own = [*own, *others]
        rows.append([f"{own[0]['parameters']['heightSteps'][0]:g}", *(figure(beyond(record), 3) for record in own),
                     *(figure(record["leak_rate"], 1, 100.0) for record in own),
                     *(figure(record["false_shadow_rate"], 2, 100.0) for record in own),
                     FETCHES_ALONE(own[:-1]), FETCHES_ALONE(others)])
    head = ["steps", *(f"{what}, {scene}" for what in ("RMSE", "light leaks, %", "false shadow, %") for scene in scenes),
            "fetches per pixel", "fetches per pixel, at the worst azimuth"]
    return f"{results['device']}. {made(results)}. {made(worst)}.\n\n{table(head, rows, 0)}"


def far_seams(results):
    """The step of the error at the shadow distance and elsewhere, one row per technique."""
    rows = [[own[0]["title"], *(f"{figure(record['far_seam']['step'], 4)} ({figure(record['far_seam']['elsewhere'], 4)})"
                                for record in own)] for _, own in groups(results["records"], "technique")]
    pairs = [f"`{own[0]['scene']}`, {own[0]['far_seam']['pairs']} pairs of pixels"
             for _, own in groups(results["records"], "scene")]
    return f"{made(results)}.\n\n{table(['technique', *pairs], rows, 1)}"


def far_sizes(results):
    """The error beyond the shadow distance by the number of texels, one row per number and technique."""
    rows = [[size, own[0]["title"], *(figure(beyond(record), 3) for record in own),
             figure(own[0]["baked_mebibytes"], 2)]
            for size in SIZES for _, own in groups(results[size]["records"], "technique")]
    head = ["texels", "technique", *(f"`{scene}`" for scene in distinct(results[SIZES[-1]]["records"], "scene")), "MiB"]
    return f"{made(results[SIZES[0]])}, and so on.\n\n{table(head, rows, 2)}"


def far_azimuths(results):
    """The error beyond the shadow distance, leaks and false shadow of each technique, one row per azimuth."""
    figures = {"RMSE": lambda record: figure(beyond(record), 3),
               "light leaks, %": lambda record: figure(record["leak_rate"], 1, 100.0),
               "false shadow, %": lambda record: figure(record["false_shadow_rate"], 1, 100.0)}
    rows = [[f"{azimuth:g}°", *(of(record) for record in results[azimuth]["records"] for of in figures.values()),
             sum(ring["pixels"] for ring in rings_beyond(results[azimuth]["records"][0])),
             results[azimuth]["records"][0]["pixels"]] for azimuth in AZIMUTHS]
    head = ["azimuth", *(f"{record['title']}: {what}" for record in results[AZIMUTHS[0]]["records"] for what in figures),
            "pixels beyond", "pixels of the picture"]
    return f"{made(results[AZIMUTHS[0]])}, and so on.\n\n{table(head, rows, 1)}"


def parts(_):
    return {DOCUMENTATION / "far-shadows.md": {
        "far-distances": far_distances(read("far-shadows")),
        "far-steps": far_steps(read("far-steps"), read("far-steps-azimuth")),
        "far-seams": far_seams(read("far-shadows")),
        "far-sizes": far_sizes({size: read(f"far-sizes/{size}") for size in SIZES}),
        "far-azimuths": far_azimuths({azimuth: read(f"far-azimuths/{azimuth:g}") for azimuth in AZIMUTHS}),
        "far-clouds": far_distances(read("far-clouds"))}}
