"""Blocks of results, costs and presets: rounding, intervals, tables and what is refused, from made-up records."""
import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools" / "pages"))
import cost  # noqa: E402
import figures  # noqa: E402
import markdown  # noqa: E402
import preset_figures  # noqa: E402
import result_block  # noqa: E402
import rounding  # noqa: E402
import technique_facts  # noqa: E402


class Rounding(unittest.TestCase):
    def test_a_figure_has_no_more_digits_than_its_interval(self):
        for value, half, text in ((0.14712, 0.0312, "0.147 ± 0.031"), (0.14712, 0.0412, "0.15 ± 0.04"),
                                  (0.14712, 0.0996, "0.15 ± 0.10"), (0.5, 0.0042, "0.500 ± 0.004"),
                                  (44.21, 12.3, "44 ± 12"), (0.14712, 0.00004, "0.147"), (4.0, 0.0, "4"),
                                  (40.04, 0.0, "40.0")):
            self.assertEqual(rounding.rounded(value, value - half, value + half, 4), text)
        self.assertEqual(rounding.rounded(40.04, 40.0, 40.08, 1), "40.0", "a tenth of a fetch is the finest")

    def test_an_interval_that_is_cut_off_has_both_ends(self):
        self.assertEqual(rounding.rounded(0.07, 0.0, 0.17, 4), "0.07 [0, 0.17]")
        self.assertEqual(rounding.rounded(90.0, 65.2, 100.0, 4), "90 [65, 100]")

    def test_intervals_are_students(self):
        # The mean is 0.5, the standard error of the scenes 0.1 / sqrt(3), and t of two degrees of freedom 4.303.
        self.assertEqual(rounding.mean_text([(0.4, 0.0), (0.5, 0.0), (0.6, 0.0)]), "0.50 ± 0.25")
        # Each scene's own error adds to the variance: 0.01 * (2 + 3 * 3) / 6 with three errors of sqrt(0.03).
        centre, half = rounding.mean_with_interval((0.4, 0.5, 0.6), [math.sqrt(0.03)] * 3)
        self.assertAlmostEqual(centre, 0.5)
        self.assertAlmostEqual(half, 4.302652730 * math.sqrt(0.01 * 11 / 6), 9)
        self.assertEqual(rounding.mean_text([(0.5, 0.01)]), "0.500 ± 0.020", "of one scene, by its pixels alone")
        self.assertEqual(rounding.mean_text([]), "–")

    def test_the_quantile_is_within_a_per_cent_of_the_table(self):
        table = {1: 12.706, 2: 4.303, 3: 3.182, 4: 2.776, 6: 2.447, 11: 2.201, 30: 2.042}  # Abramowitz & Stegun, 26.10
        for degrees, exact in table.items():
            self.assertLess(abs(rounding.student(degrees) / exact - 1.0), 0.01, degrees)


def record(technique, scene, light, error, **more):
    return {"technique": technique, "title": f"Title of {technique}", "scene": scene, "light_degrees": light,
            "map_size": 2048, "map_format": "D32", "cascades": 4, "penumbra_pixels": 3000, "rmse_penumbra": error,
            "rmse_all": 0.5 * error, "leak_rate": 0.25, "false_shadow_rate": 0.0, "fetches_mean": 9.0,
            "fetches_penumbra_mean": 12.0, "preprocess_fetches_per_pixel": 0.5, "intervals": {"rmse_penumbra": None},
            **more}


def results(*records):
    return {"device": "device", "driver": "driver", "hardware": "hardware", "library_version": "1", "commit": "c0",
            "packages": [], "command": "scripts/publish made", "records": list(records),
            "frames": [{"width": 960, "height": 540}, {"width": 480, "height": 270}]}


def two_techniques(**more):
    """tent-5 and variance-32, on two scenes under two lights."""
    return results(*(record(name, scene, light, error, **more) for light in (2.0, 0.53) for scene in ("a", "b")
                     for name, error in (("tent-5", 0.2), ("variance-32", 0.1))))


class Blocks(unittest.TestCase):
    def test_a_brief_block_has_a_row_for_each_technique_and_a_column_for_each_light(self):
        text = result_block.brief(result_block.Shown(two_techniques()))
        self.assertIn("0.53° light, 2 scenes, 6000 penumbra pixels, at least 3000 per scene; 2° light, 2 scenes", text)
        self.assertIn("| Technique | RMSE in penumbra, 0.53° | RMSE in penumbra, 2° | RMSE of all pixels, 0.53° |", text)
        self.assertIn("\n| Title of tent-5 | 0.200 | 0.200 | 0.100 | 0.100 | 25 | 25 | 0 | 0 | 9.5 | 9.5 |\n"
                      "| Title of variance-32 | 0.100 | 0.100 |", text)
        self.assertTrue(text.endswith("Command: `scripts/publish made`. Penumbra 1 at commit c0, shaders compiled by"
                                      " glslang, on device, driver driver, processor hardware."), text)

    def test_one_light_has_fetches_in_penumbrae(self):
        shown = result_block.Shown(results(record("tent-5", "a", 2.0, 0.2), record("tent-5", "b", 2.0, 0.2)))
        self.assertIn("| fetches per pixel | fetches in penumbrae |", result_block.brief(shown))
        self.assertIn("| 9.5 | 12.5 |", result_block.brief(shown))

    def test_the_interval_of_one_scene_is_that_of_its_pixels(self):
        own = {"rmse_penumbra": {"low": 0.19, "high": 0.21, "standard_error": 0.005}}
        text = result_block.brief(result_block.Shown(results(record("tent-5", "a", 2.0, 0.2, intervals=own))))
        self.assertIn("| Title of tent-5 | 0.200 ± 0.010 | 0.100 |", text)
        self.assertIn("is of one scene", text)

    def test_optional_figures_stand_where_they_were_measured(self):
        plain = result_block.brief(result_block.Shown(two_techniques()))
        for absent in ("overlap", "FLIP", "rain", "perations"):
            self.assertNotIn(absent, plain)
        measured = {**two_techniques(overlap={"rmse": 0.25}, flip=0.0125, variance=0.0004, operations_per_pixel=100.0,
                                     group_step={"across": 0.03, "inside": 0.02}), "front_end": "FXC 10"}
        text = result_block.brief(result_block.Shown(measured))
        self.assertIn("| 0.250 | 0.250 | 0.013 | 0.013 | 0.020 | 0.020 | 100 | 100 |", text)
        self.assertNotIn("across tiles", text)
        self.assertIn("step across tiles", result_block.full(result_block.Shown(measured), "chart.svg"))
        del measured["front_end"]
        self.assertNotIn("perations", result_block.brief(result_block.Shown(measured)))

    def test_passes_over_the_map_are_told_from_the_others(self):
        mapped = two_techniques(passes=[{"fetches_per_pixel": 8.5, "fetches_per_cascade": 250000.0},
                                        {"fetches_per_pixel": 1.0}])
        text = result_block.full(result_block.Shown(mapped, ["variance-32", "tent-5"]), "chart.svg")
        self.assertIn("which are of 480 x 270 to 960 x 540 pixels.", text)
        self.assertIn("| Title of variance-32, `variance-32` | 0.100 | 0.100 | 25 |", text)
        self.assertIn("](chart.svg)", text)
        self.assertRegex(text, r"\n\| `variance-32` \| .* \| 1\.0 \| 1\.0 \| 80\.0 \| \d+ \+ \d+ \| .+ \| .+ \|\n\| `tent")
        self.assertRegex(text, r"\|:--(\|--:)+\|:--\|:--\|\n\| `variance-32` \|")

    def test_the_line_is_of_the_middle_light(self):
        text = result_block.line(result_block.Shown(two_techniques(), ["variance-32", "tent-5"]))
        self.assertTrue(text.endswith("2° light, mean of 2 scenes): Title of variance-32: 0.100 with 9.5 texture fetches per"
                                      " pixel (12.5 per pixel in penumbra); Title of tent-5: 0.200 with 9.5 (12.5)."), text)

    def test_a_row_that_was_not_measured_is_refused(self):
        with self.assertRaisesRegex(markdown.Problem, "'scripts/publish made' has not measured tent-6, tent-8"):
            result_block.Shown(two_techniques(), ["tent-6", "tent-5", "tent-8"])

    def test_means_over_different_scenes_are_refused(self):
        whole = two_techniques()["records"]
        for records in (whole[1:], [*whole, whole[0]]):
            with self.assertRaisesRegex(markdown.Problem, "not one record of each technique, scene and light"):
                result_block.Shown(results(*records))


class PublishedPeers(unittest.TestCase):
    def test_urps_filters_and_ours_are_the_same(self):
        """At the same bias, what stands once in a table stands for both; a package changed by hand is found."""
        shown = result_block.Shown(figures.read("equal-bias"))
        for urp, ours in (("urp-low", "four-tap"), ("urp-medium", "tent-5"), ("urp-high", "tent-7")):
            for one, same in zip(shown.of(urp), shown.of(ours), strict=True):
                self.assertEqual((one["scene"], one["fetches_mean"]), (same["scene"], same["fetches_mean"]))
                self.assertAlmostEqual(one["rmse_penumbra"], same["rmse_penumbra"], delta=0.002)


class Facts(unittest.TestCase):
    RECORD = record("t", "a", 2.0, 0.1)  # its map has four tiles of 1024 x 1024, and 16 MiB

    def test_maps_count_textures_of_the_map_and_not_of_the_picture(self):
        for texture, more in (({"extent": "map", "format": "rg32f"}, 32.0), ({"format": "rgba32f"}, 0.0),
                              ({"extent": "map", "format": "rg16", "divisor": 4}, 1.0),
                              ({"extent": "fixed", "format": "r8", "size": [1024, 512, 2]}, 1.0),
                              ({"extent": "map", "format": "r32f", "mips": 2}, 20.0),
                              ({"extent": "map", "format": "r32f", "samples": 4}, 64.0)):
            self.assertEqual(technique_facts.map_mebibytes(self.RECORD, [texture]), 16.0 + more)
        self.assertAlmostEqual(technique_facts.map_mebibytes(self.RECORD, [
            {"extent": "map", "format": "r32f", "mips": 0}]), 16.0 + 16.0 * 4.0 / 3.0, 4)
        self.assertEqual(technique_facts.map_mebibytes({**self.RECORD, "map_format": "D16"}, []), 8.0)

    def test_a_technique_has_the_graph_of_the_one_that_it_is_like(self):
        made = technique_facts.Techniques([{
            "graphs": [{"name": "part", "textures": [{"name": "a"}], "visibility": "seen", "passes": [
                {"name": "Other", "writes": ["a"]}, {"name": "p", "kernel": "See", "writes": {"_Out": "seen"}}]},
                       {"name": "whole", "parts": ["part"], "textures": [{"name": "b"}]}],
            "techniques": [{"name": "model", "graph": "whole", "use_when": "always"}, {"name": "copy", "like": "model"},
                           {"name": "alone", "like": "model", "filter": {}}]}])
        self.assertEqual(made.textures("copy"), [{"name": "a"}, {"name": "b"}])
        self.assertEqual([made.visibility_entry(name) for name in ("copy", "alone", "nobody")],
                         ["See", "Fragment", "Fragment"])
        self.assertEqual([made.advice(name)[0] for name in ("model", "copy")], ["always", ""])

    def test_cycles_are_those_of_the_likeliest_variant_of_each_program(self):
        def row(entry, count, *keywords, technique="t", **more):
            return {"family": "navi21", "entry": entry, "stage": "fragment",
                    "figures": {"inverse_throughput_cycles": count},
                    "variants": [{"technique": technique, "keywords": list(keywords)}], **more}

        rows = [row("Fragment", 1), row("Fragment", 2, "UNITY_REVERSED_Z"), row("Rows", 30), row("Columns", 400),
                row("Fragment", 9, "UNITY_REVERSED_Z", "PENUMBRA_UNLIMITED"), row("Rows", 9, technique="u"),
                row("Vertex", 9, stage="vertex"), row("Old", 9, family="polaris10"), row("Failed", 9, figures={})]
        self.assertEqual(technique_facts.cycles("t", "Fragment", rows), "2 + 430")
        self.assertEqual(technique_facts.cycles("u", "Rows", rows), "9")
        self.assertEqual(technique_facts.cycles("t", "Elsewhere", rows), "–")

    def test_every_technique_of_the_published_results_has_its_cycles(self):
        known = technique_facts.known()
        for name in (*result_block.studies.ROWS["techniques"], "preset-low", "fallback-high"):
            self.assertRegex(technique_facts.cycles(name, known.visibility_entry(name), technique_facts.cost_rows()),
                             r"^\d+( \+ \d+)?$", name)


class Cost(unittest.TestCase):
    def test_families_stand_side_by_side(self):
        def row(family, **figures):
            return {"family": family, "figures": figures,
                    "variants": [{"technique": "hard", "keywords": ["UNITY_REVERSED_Z"]}]}

        text = cost.summary({"driver": "radv", "compiler": "glslang", "command": "penumbra cost", "families": [
            {"name": "navi21", "driver": "radv"}, {"name": "d3d11", "driver": "FXC 10"}], "rows": [
                row("navi21", instructions=90, inverse_throughput_cycles=118), row("d3d11", instructions=41)]})
        self.assertTrue(text.startswith("Driver: radv, without hardware. SPIR-V: glslang. Direct3D: FXC 10.  \n"), text)
        self.assertIn("| Technique | instructions, navi21 | instructions, d3d11 | cycles per 64 lanes, navi21 |", text)
        self.assertIn("| hard | 90 | 41 | 118 |\n| tent-3 | - | - | - |", text)


class Presets(unittest.TestCase):
    def test_a_row_has_the_means_under_each_light(self):
        made = results(*(record("preset-low", scene, light, error) for light in (2.0, 0.53)
                         for scene, error in (("a", 0.1), ("b", 0.2))))
        text = preset_figures.preset_figures(made)
        self.assertIn("// Means over 2 scenes;", text)
        self.assertIn("            new[]  // Title of preset-low\n            {\n"
                      "                new PresetFigure(0.53f, 0.150f, 9.5f),\n"
                      "                new PresetFigure(2f, 0.150f, 9.5f),\n            },\n        };\n", text)
        del made["records"][-1]
        with self.assertRaisesRegex(markdown.Problem, "preset-low was not measured on every scene"):
            preset_figures.preset_figures(made)
        with self.assertRaisesRegex(markdown.Problem, "no quality preset was measured"):
            preset_figures.preset_figures(two_techniques())


if __name__ == "__main__":
    unittest.main()
