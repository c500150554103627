"""Tables of tests and counts: what is taken of their output, and what is refused."""
import json
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools" / "pages"))
import filters  # noqa: E402
import other_shadows  # noqa: E402
import presets  # noqa: E402
import validating  # noqa: E402
from figures import ROOT, json_text, read_json  # noqa: E402
from markdown import Problem, written  # noqa: E402


class Blocks(unittest.TestCase):
    def test_text_stands_between_the_markers_and_the_rest_stays(self):
        page = "a <!-- t -->old<!-- /t --> b <!-- u --><!-- /u -->"
        self.assertEqual(written(page, {"t": "new"}), "a <!-- t -->\nnew\n<!-- /t --> b <!-- u --><!-- /u -->")

    def test_each_marker_stands_once(self):
        for page in ("", "<!-- t -->", "<!-- t --><!-- t --><!-- /t -->"):
            with self.assertRaisesRegex(Problem, "once each"):
                written(page, {"t": "new"})


PLAYER = {"programs": 1300, "presets": [{"name": "preset-low", "programs": [
    {"pass": "P", "keywords": ["_A", "_B"]}, {"pass": "Q", "keywords": []}]}]}
COUNTS = {"urp": "14.0.0", "projects": {"desktop": [
    {"shader": "Universal Render Pipeline/Lit", "pass": "Forward",
     "stages": [{"stage": "vertex", "variants": 4, "what_if": 3},
                {"stage": "fragment", "variants": 4000, "what_if": 3000}]},
    {"shader": "Universal Render Pipeline/Lit", "pass": "Depth",
     "stages": [{"stage": "vertex", "variants": 2, "what_if": 2},
                {"stage": "fragment", "variants": 5, "what_if": 5}]}]}}


class Player(unittest.TestCase):
    def test_a_preset_s_programs_are_named_and_counted(self):
        text = presets.player_programs(PLAYER)
        self.assertIn("| Low | `P` `_A` `_B`, `Q` | 2 |", text)
        self.assertIn("| without stripping | every pass with every keyword set | 1300 |", text)

    def test_what_is_added_is_the_difference_over_all_passes(self):
        self.assertIn("| desktop | Lit | `Forward` | 5 | 1 | 3,005 | 1,000 |", presets.receiver_variants(COUNTS))

    def test_the_command_is_the_one_that_counts(self):
        command = " ".join(presets.receivers_command("PROJECT", "DIR"))
        self.assertIn(f"`penumbra {command}`", presets.receiver_variants(COUNTS))
        for project in presets.PROJECTS:
            settings = command.split("--stripping ")[1].split()[0].replace("PROJECT", project)
            self.assertTrue((ROOT / settings).is_file(), settings)

    def test_only_the_screen_keyword_is_the_difference(self):
        counts = read_json(presets.RECEIVERS)
        self.assertEqual(counts["condition"], presets.CONDITION)
        self.assertEqual(list(counts["projects"]), list(presets.PROJECTS))


class DistanceFields(unittest.TestCase):
    def setUp(self):
        self.results = read_json(other_shadows.FIELDS)

    def test_a_record_that_is_missing_or_doubled_is_told(self):
        for records in (self.results["marches"][1:], self.results["marches"] + self.results["marches"][:1]):
            with self.assertRaises(Problem):
                other_shadows.fields({**self.results, "marches": records})

    def test_figures_are_means_over_the_shapes(self):
        first = self.results["marches"][0]
        errors = [one["rmse"] for one in self.results["marches"]
                  if (one["march"], one["width_metres"]) == (first["march"], first["width_metres"])]
        lines = other_shadows.march_errors(self.results).splitlines()
        line = next(line for line in lines if line.startswith(f"| {other_shadows.MARCHES[first['march']]} |"))
        self.assertEqual(line.split(" | ")[1],
                         f"{sum(errors) / len(errors):.3f} ({min(errors):.3f} – {max(errors):.3f})")


RAW = {"context": {"date": "2026-01-02T03:04:05+00:00", "host_name": "builder", "executable": "/builds/someone/b",
                   "num_cpus": 2},
       "benchmarks": [{"run_name": "techniques/variants:8/x", "run_type": "iteration", "shell_ms": 99.0},
                      {"run_name": "techniques/variants:8/x", "aggregate_name": "median", "variants": 8.0,
                       "shell_ms": 60.0, "cold_ms": 15.0, "cold_ratio": 4.0, "cold_cpu_ratio": 4.5, "real_time": 7.0}]}


class Speed(unittest.TestCase):
    def test_medians_are_taken_and_the_machine_is_not_told(self):
        results = validating.figures_of_speed(RAW)
        self.assertEqual(results["sets"], [{"name": "techniques", "variants": 8.0, "shell_ms": 60.0, "cold_ms": 15.0,
                                            "cold_ratio": 4.0, "cold_cpu_ratio": 4.5}])
        self.assertEqual((results["threads"], results["date"]), (2, "2026-01-02"))
        self.assertNotIn("someone", json.dumps(results))
        self.assertNotIn("builder", json.dumps(results))

    def test_one_run_alone_is_refused(self):
        with self.assertRaises(Problem):
            validating.figures_of_speed({**RAW, "benchmarks": RAW["benchmarks"][:1]})


HALF = ("{} programs by {} on 4 sets of inputs each, seeds from {} on, 3 more not run, 1 refused; differences: 0, "
        "largest distance of two floats: {} ULP; device: llvmpipe\n")


class RandomPrograms(unittest.TestCase):
    def test_halves_of_each_compiler_are_added(self):
        results = validating.figures_of_programs(
            "[ RUN ]\n" + HALF.format(250, "glslang", 1, 1) + HALF.format(250, "FXC", 1, 1) +
            HALF.format(250, "glslang", 1000001, 2) + HALF.format(251, "FXC", 1000001, 1))
        self.assertEqual([(one["compiler"], one["programs"], one["not_run"], one["refused"], one["most_ulps"])
                          for one in results["compilers"]], [("glslang", 500, 6, 2, 2), ("FXC", 501, 6, 2, 1)])
        self.assertEqual(results["first_seeds"], [1, 1000001])

    def test_half_a_run_is_refused(self):
        with self.assertRaises(Problem):
            validating.figures_of_programs(HALF.format(250, "glslang", 1, 1))


LINE = "half: {} | texels | 0.0625 | {} | 40000 cases, two directions of depth | {}\n"


class HalfPrecision(unittest.TestCase):
    def test_lines_are_read(self):
        results = filters.figures_of_half("[ RUN ]\n" + LINE.format("Near", 0.01, "a") +
                                          LINE.format("Far, place", "inf", "a"))
        self.assertEqual([one["largest"] for one in results["functions"]], [0.01, None])
        text = filters.half_precision(results)
        self.assertIn("| texels | 0.062 | `Near`: 0.01 | `Far` place: not finite |", text)

    def test_lines_of_two_devices_and_none_are_refused(self):
        for text in (LINE.format("Near", 0.01, "a") + LINE.format("Far", 0.01, "b"), "[ RUN ]\n"):
            with self.assertRaises(Problem):
                filters.figures_of_half(text)


class JsonText(unittest.TestCase):
    def test_each_case_has_a_line(self):
        value = {"n": [1, 2], "cases": [{"a": {"b": 1}}, {"a": None}], "none": []}
        self.assertEqual(json_text(value).splitlines(), ["{", '  "n": [1, 2],', '  "cases": [', '    {"a": {"b": 1}},',
                                                         '    {"a": null}', "  ],", '  "none": []', "}"])
        self.assertEqual(json.loads(json_text(value)), value)


if __name__ == "__main__":
    unittest.main()
