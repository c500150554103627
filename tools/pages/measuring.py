"""Tables of docs/measuring.md: the same techniques on two devices, and from two compilers."""
from figures import DOCS, all_fetches, code, distinct, figure, light_heads, mean, read
from markdown import Problem, table

PAGE = DOCS / "measuring.md"
AGREEING = {"rmse_penumbra": 4, "rmse_all": 4, "bias": 4, "leak_rate": 4, "false_shadow_rate": 4, "fetches_mean": 3,
            "fetches_penumbra_mean": 3}  # with their digits
DEVICE_ROWS = 8


def paired(first, second):
    """(technique, its pairs of records) of two runs of the same."""
    def key(record):
        return record["technique"], record["scene"], record["light_degrees"]

    others = {key(record): record for record in second["records"]}
    if sorted(others) != sorted(map(key, first["records"])):
        raise Problem("the two runs have not measured the same")
    return [(name, [(record, others[key(record)]) for record in first["records"] if record["technique"] == name])
            for name in distinct(first["records"], "technique")]


def made_both(first, second, command="command", more=""):
    return (f"Commands: `{first[command]}` and `{second[command]}`,{more} at commits {first['commit']} and"
            f" {second['commit']}.")


def what_both(first):
    names = distinct(first["records"], "scene")
    return f"scene{'s' * (len(names) > 1)} {', '.join(names)}"


def front_end_differences(glslang, fxc):
    """One row per technique: error, fetches and operations of glslang's modules before optimisation and of FXC's
    bytecode."""
    if "front_end" in glslang or "front_end" not in fxc:
        raise Problem("the first run is by glslang, and the second by FXC")
    rows, apart = [], 0.0
    for technique, pairs in paired(glslang, fxc):
        errors, fetches, operations = ([mean(map(of, records)) for records in zip(*pairs)] for of in (
            lambda record: record["rmse_penumbra"], all_fetches, lambda record: record["operations_per_pixel"]))
        apart = max(apart, *(abs(one["rmse_penumbra"] - other["rmse_penumbra"]) for one, other in pairs))
        rows.append([code(technique), *(figure(value, 4) for value in errors), *(figure(value, 2) for value in fetches),
                     *(figure(value, 0) for value in operations), figure(operations[1] / operations[0], 2)])
    ratios = sorted(float(row[-1]) for row in rows)
    head = ["technique", "RMSE in penumbra, glslang", "FXC", "fetches per pixel, glslang", "FXC",
            "operations per pixel, glslang", "FXC",
            "ratio"]
    return (f"glslang against {fxc['front_end']}; {what_both(glslang)}; lights of"
            f" {', '.join(light_heads(glslang['records'], '{}'))}.  \n"
            f"{made_both(glslang, fxc)}\n\n{table(head, rows, 1)}"
            f"\n\nOf {len(rows)} techniques the median ratio of operations is {ratios[len(ratios) // 2]:.2f}, from"
            f" {ratios[0]:.2f}"
            f" to {ratios[-1]:.2f}. The largest difference of the RMSE in penumbrae is {apart:.4f}.")


def device_differences(first, second):
    """The figures of a run on each of two devices, of the techniques whose errors differ most under one of the
    lights."""
    records = first["records"]
    lights = distinct(records, "light_degrees")
    middle = lights[len(lights) // 2]
    rows, largest = [], dict.fromkeys(AGREEING, 0.0)
    for technique, pairs in paired(first, second):
        apart = {name: max(abs(one[name] - other[name]) for one, other in pairs) for name in AGREEING}
        largest = {name: max(largest[name], apart[name]) for name in AGREEING}
        pair = next(pair for pair in pairs if pair[0]["light_degrees"] == middle)
        rows.append((apart["rmse_penumbra"], [
            code(technique), *(figure(record["rmse_penumbra"], 4) for record in pair),
            figure(apart["rmse_penumbra"], 4),
            figure(max(apart["leak_rate"], apart["false_shadow_rate"]), 3, 100.0), figure(apart["fetches_mean"], 3)]))
    most = [row for _, row in sorted(rows, key=lambda row: -row[0])[:DEVICE_ROWS]]
    head = ["technique", f"RMSE in penumbra, {middle:g}° light: {first['device']}", second["device"],
            "largest difference of RMSE", "of leaks and false shadow, %", "of fetches per pixel"]
    shown = {name: figure(largest[name], digits) for name, digits in AGREEING.items()}
    return (f"{first['device']} (driver {first['driver']}) against {second['device']} (driver {second['driver']});"
            f" {what_both(first)}, lights of {', '.join(light_heads(records, '{}'))},"
            f" {min(record['penumbra_pixels'] for record in records)} penumbra pixels or more for each. Results that"
            f" are not finite or not in [0, 1]: {sum(record['invalid'] for record in records + second['records'])}.  \n"
            f"{made_both(first, second, 'measured_by', f' of {len(rows)} techniques,')} The table has the {len(most)} whose errors"
            f" differ most.\n\n"
            f"{table(head, most, 1)}\n\nOver all techniques the largest difference of the RMSE in penumbrae is"
            f" {shown['rmse_penumbra']},"
            f" of the RMSE over all pixels {shown['rmse_all']}, of the bias {shown['bias']}, of fetches per pixel"
            f" {shown['fetches_mean']}"
            f" and in penumbrae {shown['fetches_penumbra_mean']}.")


def parts(_):
    return {PAGE: {"device-differences": device_differences(read("device-gpu"), read("device-software")),
                   "front-ends": front_end_differences(read("front-ends/glslang"), read("front-ends/fxc"))}}
