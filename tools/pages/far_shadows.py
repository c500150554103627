"""Tables of Documentation~/far-shadows.md."""
import math

from figures import DOCUMENTATION, FETCHES_ALONE, all_fetches, distinct, figure, groups, made, read
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
    """A table for each scene: the error of all pixels by distance from the camera, one row per technique."""
    tables = []
    for (scene,), own in groups(results["records"], "scene"):
        rings = own[0]["by_distance"]
        head = ["technique", *(f"{ring['from_metres']:g} to {ring['to_metres']:g} m" for ring in rings),
                "light leaks, %",
                "false shadow, %", "fetches per pixel", "bakes, MiB"]
        rows = [["pixels", *(ring["pixels"] for ring in rings), "", "", "", ""]]
        rows += [[record["title"], *(figure(ring["rmse_all"], 3) for ring in record["by_distance"]),
                  figure(record["leak_rate"], 1, 100.0), figure(record["false_shadow_rate"], 1, 100.0),
                  figure(all_fetches(record), 1), figure(record.get("baked_mebibytes"), 1)] for record in own]
        tables.append(f"`{scene}`, RMSE of all pixels by distance from the camera:\n\n{table(head, rows, 1)}")
    return f"{results['device']}; one picture of each scene, one seed of the noise. {made(results)}.\n\n" + "\n\n".join(
        tables)


def far_steps(results):
    """The error beyond the shadow distance and the fetches of the height-field trace, one row per number of steps."""
    records = results["records"]
    rows = [[f"{own[0]['parameters']['heightSteps'][0]:g}", *(figure(beyond(record), 3) for record in own),
             *(figure(record["leak_rate"], 1, 100.0) for record in own),
             *(figure(record["false_shadow_rate"], 2, 100.0) for record in own), FETCHES_ALONE(own)]
            for _, own in groups(records, "technique")]
    head = ["steps", *(f"{what}, `{scene}`" for what in ("RMSE", "light leaks, %", "false shadow, %")
                       for scene in distinct(records, "scene")), "fetches per pixel"]
    return f"{results['device']}. {made(results)}.\n\n{table(head, rows, 0)}"


def far_seams(results):
    """The step of the error at the shadow distance, one row per technique and scene."""
    rows = [[record["scene"], record["title"], record["far_seam"]["pairs"],
             *(figure(record["far_seam"][key], 4) for key in ("step", "elsewhere"))] for record in results["records"]]
    head = ["scene", "technique", "pairs of pixels", "step at the shadow distance", "step elsewhere"]
    return f"{made(results)}.\n\n{table(head, rows, 2)}"


def far_sizes(results):
    """The error beyond the shadow distance by the number of texels, one row per number and technique."""
    rows = [[size, own[0]["title"], *(figure(beyond(record), 3) for record in own),
             figure(own[0]["baked_mebibytes"], 2)]
            for size in SIZES for _, own in groups(results[size]["records"], "technique")]
    head = ["texels", "technique", *(f"`{scene}`" for scene in distinct(results[SIZES[-1]]["records"], "scene")), "MiB"]
    return f"{made(results[SIZES[0]])}, and so on.\n\n{table(head, rows, 2)}"


def far_azimuths(results):
    """The error beyond the shadow distance by the sun's azimuth, one row per azimuth."""
    rows = [[f"{azimuth:g}°", record["title"], figure(beyond(record), 3),
             sum(ring["pixels"] for ring in rings_beyond(record)),
             figure(record["leak_rate"], 1, 100.0), figure(record["false_shadow_rate"], 1, 100.0), record["pixels"]]
            for azimuth in AZIMUTHS for record in results[azimuth]["records"]]
    head = ["azimuth", "technique", "RMSE beyond the shadow distance", "its pixels", "light leaks, %",
            "false shadow, %",
            "pixels of the picture"]
    return f"{made(results[AZIMUTHS[0]])}, and so on.\n\n{table(head, rows, 2)}"


def parts(_):
    return {DOCUMENTATION / "far-shadows.md": {
        "far-distances": far_distances(read("far-shadows")),
        "far-steps": far_steps(read("far-steps")),
        "far-steps-azimuth": far_steps(read("far-steps-azimuth")),
        "far-seams": far_seams(read("far-shadows")),
        "far-sizes": far_sizes({size: read(f"far-sizes/{size}") for size in SIZES}),
        "far-azimuths": far_azimuths({azimuth: read(f"far-azimuths/{azimuth:g}") for azimuth in AZIMUTHS}),
        "far-clouds": far_distances(read("far-clouds"))}}
