"""What docs/measuring.md says of the same techniques on two devices, and from two compilers."""
from figures import DOCS, distinct, figure, light_heads, mean, read
from markdown import Problem


PAGE = DOCS / "measuring.md"
AGREEING = {"rmse_penumbra": 4, "rmse_all": 4, "bias": 4, "fetches_mean": 3,
            "fetches_penumbra_mean": 3}  # with their digits


def paired(first, second):
    """(technique, its pairs of records) of two runs of the same."""
    def key(record):
        return record["technique"], record["scene"], record["light_degrees"]

    others = {key(record): record for record in second["records"]}
    if sorted(others) != sorted(map(key, first["records"])):
        raise Problem("the two runs have not measured the same")
    return [(name, [(record, others[key(record)]) for record in first["records"] if record["technique"] == name])
            for name in distinct(first["records"], "technique")]


def made_both(first, second, command="command"):
    return (f"Commands: `{first[command]}` and `{second[command]}`, at commits {first['commit']} and"
            f" {second['commit']}.")


def what_both(first):
    names = distinct(first["records"], "scene")
    return f"scene{'s' * (len(names) > 1)} {', '.join(names)}"


def front_end_differences(glslang, fxc):
    """How far errors and operations of glslang's modules before optimisation and of FXC's bytecode lie apart."""
    if "front_end" in glslang or "front_end" not in fxc:
        raise Problem("the first run is by glslang, and the second by FXC")
    ratios, apart = [], 0.0
    for _, pairs in paired(glslang, fxc):
        operations = [mean(record["operations_per_pixel"] for record in records) for records in zip(*pairs)]
        ratios.append(operations[1] / operations[0])
        apart = max(apart, *(abs(one["rmse_penumbra"] - other["rmse_penumbra"]) for one, other in pairs))
    ratios.sort()
    return (f"glslang against {fxc['front_end']}; {what_both(glslang)}; lights of"
            f" {', '.join(light_heads(glslang['records'], '{}'))}. Of {len(ratios)} techniques the median ratio of FXC's"
            f" operations to glslang's is {ratios[len(ratios) // 2]:.2f}, from {ratios[0]:.2f} to {ratios[-1]:.2f}. The"
            f" largest difference of the RMSE in penumbrae is {apart:.4f}. {made_both(glslang, fxc)}")


def device_differences(first, second):
    """How far the figures of a run on each of two devices lie apart."""
    records, runs = first["records"], paired(first, second)
    shown = {name: figure(max(abs(one[name] - other[name]) for _, pairs in runs for one, other in pairs), digits)
             for name, digits in AGREEING.items()}
    return (f"{first['device']} (driver {first['driver']}) against {second['device']} (driver {second['driver']});"
            f" {what_both(first)}, lights of {', '.join(light_heads(records, '{}'))},"
            f" {min(record['penumbra_pixels'] for record in records)} penumbra pixels or more for each. Over {len(runs)}"
            f" techniques the largest difference of the RMSE in penumbrae is {shown['rmse_penumbra']}, of the RMSE over all"
            f" pixels {shown['rmse_all']}, of the bias {shown['bias']}, of fetches per pixel {shown['fetches_mean']} and in"
            f" penumbrae {shown['fetches_penumbra_mean']}. Results that are not finite or not in [0, 1]:"
            f" {sum(record['invalid'] for record in records + second['records'])}. "
            f"{made_both(first, second, 'measured_by')}")


def parts(_):
    return {PAGE: {"device-differences": device_differences(read("device-gpu"), read("device-software")),
                   "front-ends": front_end_differences(read("front-ends/glslang"), read("front-ends/fxc"))}}
