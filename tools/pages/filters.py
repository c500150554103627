"""The table of 16-bit arithmetic in Documentation~/filters.md."""
import json
import math
import re
from pathlib import Path

from figures import DOCUMENTATION, ROOT, read_json
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

    rows = [[f"`{one['function'].split(',')[0]}`" + "".join(one["function"].partition(",")[1:]),
             "fit" if is_fit(one) else "**unfit**", one["unit"], digits(one["largest"]), digits(one["accepted"])]
            for one in sorted(results["functions"], key=lambda one: not is_fit(one))]
    return (f"{results['device']}; {results['cases']} for each function. Command:"
            f" `build/release/penumbra_ShaderLibrary_tests"
            " --gtest_filter='*HalfPrecision*' > TEXT; scripts/pages --take half TEXT`\n\n"
            + table(["function", "in half", "the difference's unit", "largest difference", "accepted"], rows, 3))


def take_half(file):
    """FILE is the output of penumbra_ShaderLibrary_tests."""
    HALF.write_text(json.dumps(figures_of_half(Path(file).read_text()), indent=2) + "\n")


TAKES = {"half": take_half}


def parts(_):
    return {DOCUMENTATION / "filters.md": {"half": half_precision(read_json(HALF))}}
