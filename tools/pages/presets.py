"""Tables of Documentation~/presets.md, with what a player contains."""
import json
import math
import subprocess
from pathlib import Path

from figures import (COMMAND, DOCUMENTATION, ROOT, all_fetches, by_light, code, distinct, groups, interval_of, light_heads,
                     made, mean_of, measured, read, read_json, scenes, techniques_by_light, with_interval, write_json)
from markdown import Problem, table
import time_model

PAGE = DOCUMENTATION / "presets.md"


def preset_steps(results):
    """By how much the error falls from each preset to the next: one row per step, lights are columns."""
    presets = {name: own for (name,), own in groups(results["records"], "technique") if name.startswith("preset-")}
    rows = []
    for lower, higher in zip(presets, list(presets)[1:]):
        errors = {(record["light_degrees"], record["scene"]): record["rmse_penumbra"] for record in presets[higher]}

        def cell(records):
            pairs = [(one["rmse_penumbra"], errors.get((one["light_degrees"], one["scene"]))) for one in records]
            differences = [before - after for before, after in pairs if None not in (before, after)]
            step = with_interval(differences)
            shown = "-" if step is None else f"{step[0]:.4f} ± {step[1]:.4f}"
            return f"{shown} ({sum(difference > 0.0 for difference in differences)} of {len(differences)})"

        rows.append([" to ".join(name.removeprefix("preset-").capitalize() for name in (lower, higher)),
                     *by_light(presets[lower], cell)])
    return (f"Command: `{COMMAND}`. It reads `Documentation~/results/presets/results.tsv` in the repository, which the"
            f" command below the first tables"
            f" writes.\n\n{table(['from, to', *light_heads(results['records'])], rows, 1)}")


def executed_operations(results):
    """Operations per pixel that FXC's bytecode executes."""
    if "front_end" not in results:
        raise Problem("operations are those of optimised bytecode: measure with --front-end fxc")
    return measured({**results, "device": results["front_end"]}, *techniques_by_light(
        results, "operations per pixel", interval_of("operations_per_pixel", 0, math.inf)),
        what=scenes(results["records"]))


def each_frame(record):
    """Fetches per pixel of all passes but those that run only for a cascade that is drawn anew."""
    return all_fetches(record) - sum(one["fetches_per_pixel"] for one in record.get("passes", [])
                                     if one["runs"] == "cascade")


def masks(results):
    """Fetches per pixel without a mask, with it and with the conservative one, and what each mask skips and misses:
    means."""
    records = results["records"]
    names = distinct(records, "technique")
    plain, *settings = names[0].split(" ")
    if names != [" ".join([plain + mask, *settings]) for mask in ("", "-masked", "-conservative")]:
        raise Problem(f"results/masks/results.tsv holds {names}, not one technique without a mask, with it, and with"
                      " the conservative one")
    once = {sum(one["fetches_per_cascade"] for one in record["passes"] if one["runs"] == "cascade")
            for record in records if record["technique"] == names[2]}
    if len(once) != 1:
        raise Problem(f"results/masks/results.tsv: the passes over a cascade fetch {sorted(once)} times, not as often"
                      f" everywhere")

    def cells(names, cell):
        return by_light(records,
                        lambda own: " → ".join(cell([one for one in own if one["technique"] == name])
                                               for name in names))

    rows = [["fetches per pixel, without a mask → four taps → conservative mask",
             *cells(names, mean_of(each_frame, 1))],
            ["pixels that the mask skips, %: four taps → conservative mask",
             *cells(names[1:], mean_of(lambda record: record["mask"]["pixels_saved"], 0, 100))],
            ["penumbra pixels that it misses, %",
             *cells(names[1:], mean_of(lambda record: record["mask"]["penumbra_pixels_missed"], 2, 100))]]
    return (f"{results['device']}. Not counted: {once.pop() / 1e6:.2f} million fetches for each cascade of 1024 x 1024"
            f" texels that is"
            f" drawn anew, for the conservative mask. {made(results)}.\n\n"
            + table([f"mean of {len(distinct(records, 'scene'))} scenes", *light_heads(records)], rows, 1))


VARIANTS = DOCUMENTATION / "variants"
RECEIVERS = VARIANTS / "receivers.json"
PROJECTS = ("desktop", "phone")
URP = "com.unity.render-pipelines.universal"
SHADERS = ("Lit", "SimpleLit", "Terrain/TerrainLit")
CONDITION = "-_MAIN_LIGHT_SHADOWS_SCREEN"


def receivers_command(project, urp):
    """Of one project; `urp` is the folder with URP's packages."""
    packages = [f"com.unity.render-pipelines.{name}" for name in ("core", "universal", "universal-config")]
    roots = [option for package in packages for option in ("--package-root", f"{package}={urp}/{package}")]
    return ["validate", *(f"{urp}/{URP}/Shaders/{shader}.shader" for shader in SHADERS), *roots, "--api", "d3d11",
            "--stripping", f"Documentation~/variants/{project}.json", "--count", f"--what-if={CONDITION}"]


def take_receivers(urp):
    """Counts anew; `urp` is the folder with URP's packages."""
    projects = {}
    for project in PROJECTS:
        run = subprocess.run([ROOT / "build" / "release" / "penumbra", *receivers_command(project, urp), "--format",
                              "json"],
                             cwd=ROOT, capture_output=True, text=True)
        if run.returncode != 0:
            raise Problem(f"penumbra validate ended with {run.returncode}: {run.stderr.strip()}")
        projects[project] = [{key: program[key]
                              for key in ("shader", "pass", "stages")}  # without this machine's folders
                             for program in json.loads(run.stdout)["programs"]]
    version = read_json(Path(urp) / URP / "package.json")["version"]
    write_json(RECEIVERS, {"urp": version, "condition": CONDITION, "projects": projects})


def player_programs(counts):
    rows = [[preset["name"].removeprefix("preset-").capitalize(),
             ", ".join(" ".join(map(code, [program["pass"], *program["keywords"]])) for program in preset["programs"]),
             len(preset["programs"])] for preset in counts["presets"]]
    rows.append(["without stripping", "every pass with every keyword set", counts["programs"]])
    return "Command: `penumbra emit`\n\n" + table(["preset", "programs", "number"], rows, 2)


def receiver_variants(counts):
    def sums(programs, key):
        return [sum(stage[key] for program in programs for stage in program["stages"] if stage["stage"] == name)
                for name in ("vertex", "fragment")]

    rows = []
    for project, programs in counts["projects"].items():
        for (shader,), own in groups(programs, "shader"):
            changed = [program for program in own
                       if any(stage["variants"] != stage["what_if"] for stage in program["stages"])]
            figures = [f"{count:,}" for after, before in zip(sums(own, "variants"), sums(own, "what_if"))
                       for count in (before, after - before)]
            rows.append([project, shader.removeprefix("Universal Render Pipeline/"),
                         ", ".join(code(program["pass"]) for program in changed), *figures])
    head = ["project", "shader", "passes that grow", "vertex programs before", "added", "fragment programs before",
            "added"]
    command = " ".join(["penumbra", *receivers_command("PROJECT", "DIR")])
    return f"URP {counts['urp']}, Direct3D 11. Command: `{command}`\n\n{table(head, rows, 3)}"


TAKES = {"receivers": take_receivers}


def parts(_):
    return {PAGE: {"preset-steps": preset_steps(read("presets")),
                   "preset-operations": executed_operations(read("preset-operations")),
                   "predicted-times": time_model.predictions(read("tiled-pcss-full-hd"), read("gpu-times/1920x1080"),
                                                             read("gpu-operations"), 2.0),
                   "masks": masks(read("masks")),
                   "player-programs": player_programs(read_json(VARIANTS / "presets.json")),
                   "receiver-variants": receiver_variants(read_json(RECEIVERS))}}
