"""Tables of docs/validating.md: the corpus of published shaders, speed, random programs."""
import re
from pathlib import Path

from figures import DOCS, ROOT, read_json, write_json
from markdown import Problem, table

PAGE = DOCS / "validating.md"
CORPUS = ROOT / "tests" / "corpus"
SPEED = ROOT / "tests" / "benchmarks" / "validation_results.json"
PROGRAMS = ROOT / "tests" / "programs" / "last_run.json"


def share(part, whole):
    return f"{part} ({100 * part / whole:.1f} %)" if whole else "-"


def total(counts):
    return {key: sum(one[key] for one in counts) for key in counts[0]}


BLOCKS = ["blocks", "left out", "SPIR-V", "also ESSL, GLSL, MSL", "also HLSL"]


def of_blocks(blocks):
    return [blocks["total"], blocks["editor_only"] + blocks["include_missing"],
            *(share(blocks[key], blocks["counted"]) for key in ("spirv", "all_but_hlsl", "all_targets"))]


def of_first_run(entry):
    """Blocks to SPIR-V and blocks that count. The very first run found fewer includes through its own fault, so those
    that were missing count in it."""
    blocks = entry["blocks"]
    return blocks["spirv"], blocks["counted"] if entry.get("found_includes") else blocks["total"] - blocks[
        "editor_only"]


def corpus(first, last):
    """One row for all third-party repositories, and one for each version of URP: blocks, and of URP all keyword sets of
    its Lighting.hlsl."""
    before = [of_first_run(entry) for entry in first["results"]]
    lighting = {entry["version"]: share(entry["all_targets"], entry["keyword_sets"]) for entry in last["lighting"]}
    rows = [[f"{len(last['third_party'])} repositories", share(*map(sum, zip(*before))),
             *of_blocks(total([one["blocks"] for one in last["third_party"]])), "-"]]
    rows += [[f"URP {entry['version']}", "-", *of_blocks(entry["blocks"]), lighting[entry["version"]]]
             for entry in last["urp"]]
    return table(["shaders", "SPIR-V, first run", *BLOCKS, "keyword sets of Lighting.hlsl, all targets"], rows, 1)


def named_causes(last):
    places = {"third_party": "{repository}", "urp": "URP {version}", "lighting": "lighting.hlsl, URP {version}"}
    return [(place.format(**entry), cause) for part, place in places.items() for entry in last[part]
            for cause in entry["causes"]]


def causes(last, explanations):
    """One row for each kind of cause."""
    found = [[] for _ in explanations]
    for where, cause in named_causes(last):
        matching = [i for i, one in enumerate(explanations) if one["message"] in cause["message"]
                    and one.get("where", "") in where]
        if len(matching) != 1:
            raise Problem(f"{len(matching)} explanations fit '{cause['message']}' of {where}; explanations.json needs"
                          f" one")
        found[matching[0]].append((where, cause))
    kinds = {}
    for explanation, of in zip(explanations, found):
        if not of:
            raise Problem(f"nothing fails with '{explanation['message']}' any more; take it out of explanations.json")
        kinds.setdefault(explanation["kind"], []).append(sum(cause["blocks"] for _, cause in of))
    rows = sorted(([kind, len(blocks), sum(blocks)] for kind, blocks in kinds.items()), key=lambda row: -row[-1])
    return table(["cause", "messages", "blocks"], rows, 1)


def front_ends(data):
    """One row for all third-party repositories, and one for each version of URP."""
    def row(name, entries):
        one = total([{**{key: entry[key] for key in ("variants", "accepted_by_fxc", "passed_by_us")},
                      **{kind: sum(cause["variants"] for cause in entry[kind])
                         for kind in ("false_passes", "false_refusals")}} for entry in entries])
        return [name, one["variants"], share(one["accepted_by_fxc"], one["variants"]),
                share(one["passed_by_us"], one["variants"]), one["false_passes"], one["false_refusals"]]

    rows = [row(f"{len(data['third_party'])} repositories", data["third_party"]),
            *(row(f"URP {entry['version']}", [entry]) for entry in data["urp"])]
    return f"{data['fxc']}.\n\n" + table(["shaders", "variants", "FXC accepts", "glslang passes", "false passes",
                                          "false refusals"], rows, 1)


def judged(data, pipelines):
    """One row for the later repositories of each pipeline, and one for Unity's built-in shaders."""
    def row(name, entries):
        one = total([entry["blocks"] for entry in entries])
        return [name, one["total"], one["editor_only"] + one["include_missing"] + one["other_apis"],
                share(one["accepted_by_fxc"], one["counted"]),
                *(share(one[key], one["accepted_by_fxc"]) for key in ("spirv", "all_targets")), one["from_bytecode"]]

    def of(pipeline):
        return [entry for entry in data["later"] if pipelines[entry["repository"]].startswith(pipeline)]

    rows = [row(f"{len(of(pipeline))} repositories, {name}", of(pipeline))
            for pipeline, name in (("built-in", "built-in pipeline"), ("17", "URP 17"), ("14", "URP 14"))]
    rows.append(row(f"Unity's built-in shaders, {data['built_in']['version']}", [data["built_in"]]))
    return f"{data['fxc']}.\n\n" + table(["shaders", "blocks", "left out", "FXC accepts", "of these SPIR-V",
                                          "of these all targets", "from bytecode"], rows, 1)


SETS = {"techniques": "this library's techniques", "urp_lighting": "URP's Lighting.hlsl"}


def processor():
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown")


def figures_of_speed(raw):
    """The figures of the benchmark's own JSON, without what names a machine's folders; several repetitions of
    one benchmark are there by their median."""
    sets = [{"name": run["run_name"].split("/")[0],
             **{name: round(value, 6) for name, value in run.items()
                if name.endswith(("_ms", "_ratio", "texts", "modules")) or name == "variants"}}
            for run in raw["benchmarks"] if run.get("aggregate_name") == "median"]
    if not sets:
        raise Problem("no medians in it: give the benchmark --benchmark_repetitions=3")
    return {"command": "penumbra_validation_benchmark --benchmark_repetitions=3"
                       " --benchmark_filter='variants:(72|288|1000)'",
            "processor": processor(), "threads": raw["context"]["num_cpus"], "date": raw["context"]["date"][:10],
            "sets": sets}


def ratio(value):
    return f"{value:.2f}" if value < 100 else f"{value:.0f}"


def of_way(of, way):
    """Milliseconds and speed-up. The library's techniques have one source for all targets, and so no figure of the
    default."""
    if way + "_ms" not in of:
        return "–"
    return f"{of[way + '_ms']:.{2 if way == 'warm' else 0}f} ({ratio(of[way + '_ratio'])} ×)"


def machine(results):
    return f"{results['processor']}, {results['threads']} threads, {results['date']}. Command: `{results['command']}`"


def title(of):
    return f"{SETS[of['name']]}, {of['variants']:.0f} variants"


def speed_summary(results):
    rows = [[title(of), f"{of['shell_ms']:.0f}",
             *(of_way(of, way) for way in ("alone", "shared", "lint", "default", "warm"))] for of in results["sets"]]
    head = ["milliseconds per variant (speed-up)", "shell pipeline", "the same steps, in one process",
            "shared", "the command, `--api vulkan`", "the command", "again, with a filled cache"]
    return f"{machine(results)}\n\n{table(head, rows, 1)}"


HALF = re.compile(r"^(\d+) programs by (\w+) on (\d+) sets of inputs each, seeds from (\d+) on, (\d+) more not run, "
                  r"(\d+) refused; differences: (\d+), largest distance of two floats: (\d+) ULP; device: (.+)$",
                  re.MULTILINE)


def of_compiler(compiler, halves):
    if len(halves) != 2:
        raise Problem(f"{len(halves)} halves by {compiler} in it instead of 2: run all of '*Half*'")
    programs, unfit, refused, differences = (sum(int(half[at]) for half in halves) for at in (0, 4, 5, 6))
    return {"compiler": compiler, "programs": programs, "not_run": unfit, "refused": refused,
            "differences": differences, "most_ulps": max(int(half[7]) for half in halves)}


def figures_of_programs(text):
    found = HALF.findall(text)
    if len({(half[2], half[8]) for half in found}) != 1:
        raise Problem("the halves are of different runs")
    return {"input_sets": int(found[0][2]), "first_seeds": [int(seed) for seed in dict.fromkeys(half[3] for half in found)],
            "device": found[0][8],
            "compilers": [of_compiler(compiler, [half for half in found if half[1] == compiler])
                          for compiler in dict.fromkeys(half[1] for half in found)]}


def random_programs(results):
    rows = [["FXC, its bytecode" if one["compiler"] == "FXC" else one["compiler"], f"{one['programs']:,}",
             results["input_sets"], one["not_run"], one["refused"], one["differences"], f"{one['most_ulps']} ULP"]
            for one in results["compilers"]]
    return (f"{results['device']}, seeds from {' and '.join(map(str, results['first_seeds']))} on. Command:"
            f" `PENUMBRA_RANDOM_PROGRAMS={results['compilers'][0]['programs']} build/release/penumbra_programs_tests"
            f" --gtest_filter='*Half*' > TEXT;"
            " scripts/pages --take programs TEXT`\n\n"
            + table(["compiler", "programs", "sets of inputs each", "left out", "refused", "differences",
                     "largest distance of two floats"], rows, 1))


def take_speed(file):
    """FILE is what penumbra_validation_benchmark has written with --benchmark_out=FILE."""
    write_json(SPEED, figures_of_speed(read_json(Path(file))))


def take_programs(file):
    """FILE is the output of penumbra_programs_tests."""
    write_json(PROGRAMS, figures_of_programs(Path(file).read_text()))


TAKES = {"speed": take_speed, "programs": take_programs}


def parts(_):
    first, last, explanations, both, with_fxc, listed = (
        read_json(CORPUS / f"{name}.json") for name in
        ("first_run", "last_run", "explanations", "front_ends", "fxc_run", "third_party_shaders"))
    pipelines = {entry["repository"]: entry.get("pipeline", "built-in") for entry in listed["later"]}
    measured = read_json(SPEED)
    return {PAGE: {"front-ends": front_ends(both), "corpus": corpus(first, last), "causes": causes(last, explanations),
                   "judged": judged(with_fxc, pipelines),
                   "validation-speed": speed_summary(measured), "programs": random_programs(read_json(PROGRAMS))}}
