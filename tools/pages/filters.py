"""The table of 16-bit arithmetic in Documentation~/filters.md."""
import math
import re
from pathlib import Path

from figures import DOCUMENTATION, ROOT, read_json, write_json
from markdown import Problem, table

HALF = ROOT / "tests" / "ShaderLibrary" / "half_precision.json"
LINE = re.compile(r"^half: (.+) \| (.+) \| (\S+) \| (\S+) \| (.+) \| (.+)$", re.MULTILINE)


def figures_of_half(text):
    lines = LINE.findall(text)
    if not lines:
        raise Problem("no line of a function in it: the device may have no 16-bit arithmetic")
    if len({(cases, device) for *_, cases, device in lines}) != 1:
        raise Problem("its lines are of different runs")
    return {"device": lines[0][5], "cases": lines[0][4],
            "functions": [{"function": name, "unit": unit, "accepted": float(accepted),
                           "largest": float(largest) if math.isfinite(float(largest)) else None}
                          for name, unit, accepted, largest, _, _ in lines]}


def half_precision(results):
    def is_fit(one):
        return one["largest"] is not None and one["largest"] <= one["accepted"]

    def digits(number):
        return "not finite" if number is None else f"{number:.2g}"

    kinds = {}
    for one in results["functions"]:
        name, _, which = one["function"].partition(",")
        of_unit = kinds.setdefault((one["unit"], one["accepted"]), ([], []))
        of_unit[0 if is_fit(one) else 1].append(f"`{name}`{which}: {digits(one['largest'])}")
    rows = [[unit, digits(accepted), *(", ".join(ones) or "-" for ones in of_unit)]
            for (unit, accepted), of_unit in kinds.items()]
    return (f"{results['device']}; {results['cases']} for each function. Command:"
            f" `build/release/penumbra_ShaderLibrary_tests"
            " --gtest_filter='*HalfPrecision*' > TEXT; scripts/pages --take half TEXT`\n\n"
            + table(["largest difference, in", "accepted", "fit", "unfit"], rows, 4))


def take_half(file):
    """FILE is the output of penumbra_ShaderLibrary_tests."""
    write_json(HALF, figures_of_half(Path(file).read_text()))


TAKES = {"half": take_half}


def parts(_):
    return {DOCUMENTATION / "filters.md": {"half": half_precision(read_json(HALF))}}
