"""Tables of measured figures: means, intervals, pairs and orders of rows, from records that are made up."""
import math
import re
import runpy
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools" / "pages"))
import far_shadows  # noqa: E402
import figures  # noqa: E402
import markdown  # noqa: E402
import measuring  # noqa: E402
import other_shadows  # noqa: E402
import presets  # noqa: E402
import results_table  # noqa: E402
import screen_passes  # noqa: E402
import tiled_pcss  # noqa: E402
import time_model  # noqa: E402

PARTS = ("mask", "shimmer", "seam", "error_split", "reference", "settings",
         "intervals")  # parts of a record with fields of their own


COMMIT = "0123456789" * 4


def record(technique, scene="a", light=2.0, mask=None, shimmer=None, **figures):
    made = {"technique": technique, "scene": scene, "light_degrees": light, "rmse_penumbra": 0.1, "fetches_mean": 4.0,
            "preprocess_fetches_per_pixel": 0.0, "penumbra_pixels": 3000, **figures}
    if mask:
        made["mask"] = {"pixels_saved": mask[0], "penumbra_pixels_missed": mask[1]}
    if shimmer:
        made["shimmer"] = {"frames": 3, "static_noise": shimmer[0], "per_frame_noise": shimmer[1]}
    return made


def results(*records):
    return {"device": "device", "command": "penumbra measure --made", "commit": COMMIT, "records": list(records)}


class Fields(unittest.TestCase):
    def test_every_field_of_a_record_has_its_meaning(self):
        figures_of = measuring.PAGE.read_text().split("\n## Figures\n")[1].split("\n## ")[0]
        cells = re.findall(r"^\| (.*?) \|", figures_of, re.MULTILINE)
        named = {name for cell in cells for name in re.findall("`([^`]*)`", cell)}
        for file in figures.RESULTS.glob("**/results.tsv"):
            for record in results_table.read_table(file.read_text())["records"]:
                parts = [record, *(record[part] for part in PARTS if part in record)]
                self.assertLessEqual({name for part in parts for name in part}, named,
                                     f"{file}: say it in docs/measuring.md")


class Volumetric(unittest.TestCase):
    def test_rows_are_means_over_scenes(self):
        def one(scene, jittered, rmse, blocks):
            return {"scene": scene, "extinction_per_metre": 0.05, "samples": 8, "jittered": jittered, "rmse": rmse,
                    "rmse_of_blocks": blocks}

        text = other_shadows.volumetric({"device": "d", "command": "c", "commit": COMMIT, "picture": [160, 90],
                                         "map": [64, 32], "cascades": 2,
                                "longest_ray_metres": 50.0, "places_of_the_exact_answer": 256, "block_pixels": 4,
                                "records": [one("a", False, 0.2, 0.1), one("a", True, 0.3, 0.02),
                                            one("b", False, 0.2, 0.3), one("b", True, 0.3, 0.02)]})
        # Where the scenes differ, the mean is 0.2 ± 12.706 * 0.1, which goes below 0 and above 1.
        self.assertTrue(text.endswith("| 0.05 | 8 | 0.200 ± 0.000 | 0.300 ± 0.000 | 0.200 [0, 1] | 0.020 ± 0.000 |"),
                        text)


class Provenance(unittest.TestCase):
    def test_results_of_changed_sources_or_of_no_commit_are_refused(self):
        self.assertTrue(figures.made(results()).endswith(f", at commit {COMMIT}"))
        for commit in (COMMIT + "-dirty", COMMIT[1:], "", None):
            with self.assertRaisesRegex(markdown.Problem, "nobody can check out"):
                figures.made({**results(), "commit": commit})


class Intervals(unittest.TestCase):
    def test_an_interval_ends_where_the_figure_does(self):
        self.assertEqual(figures.mean_and_interval([0.4, 0.5, 0.6], 3), "0.500 ± 0.248")
        self.assertEqual(figures.mean_and_interval([0.0, 0.1, 0.2], 3), "0.100 [0, 0.348]")
        self.assertEqual(figures.mean_and_interval([80.0, 90.0, 100.0], 1, 100.0), "90.0 [65.2, 100]")
        self.assertEqual(figures.mean_and_interval([0.0, 100.0], 1, 100.0), "50.0 [0, 100]")
        self.assertEqual(figures.mean_and_interval([0.3], 3), "0.300")


class Noise(unittest.TestCase):
    @staticmethod
    def results():
        def of(name, scene, history, error, variance):
            return record(f"pcss-{name} history={history}", scene, title=f"PCSS, {name} noise history={history}",
                          rmse_penumbra=error, rmse_all=0.5 * error, variance=variance)

        return results(of("gradient", "a", 1, 0.2, 0.04), of("gradient", "a", 0.1, 0.1, 0.0004),
                       of("mask", "a", 1, 0.21, 0.04), of("mask", "a", 0.1, 0.1, 0.0001),
                       of("gradient", "b", 1, 0.2, 0.04), of("gradient", "b", 0.1, 0.1, 0.0004),
                       of("mask", "b", 1, 0.23, 0.04), of("mask", "b", 0.1, 0.1, 0.0001))

    def test_a_row_has_single_frames_and_their_history(self):
        self.assertIn("| PCSS, gradient noise | 0.200 ± 0.000 | 0.100 ± 0.000 | 0.0200 ± 0.0000 | 4.0 |",
                      screen_passes.noise_rows(self.results()))

    def test_one_history_is_wanted(self):
        with self.assertRaisesRegex(markdown.Problem, "not one history"):
            screen_passes.noise_rows(results(record("pcss-gradient history=1")))

    def test_a_row_of_a_pan_has_both_kinds_of_noise(self):
        text = screen_passes.noise_pan(results(record("t", title="T", shimmer=(0.02, 0.03)),
                                               record("t", "b", title="T", shimmer=(0.04, 0.05))))
        self.assertIn("| T | 0.0300 [0, 0.1571] | 0.0400 [0, 0.1671] |", text)


class TexelErrors(unittest.TestCase):
    @staticmethod
    def results(*more):
        errors = {("bilinear", None): 0.3, ("disc", 0.5): 0.25, ("disc", 0.9): 0.2, ("shipped", 1.0): 0.21,
                  ("shipped", 1.125): 0.24,
                  ("shipped", 1.25): 0.2, ("mean edge", None): 0.1, ("revectorised 16 x 16", 0.5): 0.3,
                  ("learned", None): 0.19,
                  ("learned of its kind", None): 0.18}
        records = []
        for radius, shapes, scale in ((0.25, "edges", 1.0), (1.0, "edges", 0.5), (0.25, "bars", 2.0)):
            for (estimator, floor), error in errors.items():
                one = {"shapes": shapes, "radius_texels": radius, "estimator": estimator,
                       "rmse_penumbra": scale * error,
                       "half_penumbra": 0.001 * scale, "rmse_all": 0.5, "half_all": 0.00213, "receivers_penumbra": 70}
                records.append(one if floor is None else {**one, "floor_texels": floor})
        return {"command": "penumbra_texel_errors FILE", "commit": COMMIT, "receivers": 100, "trained": 200,
                "records": records + list(more)}

    def test_the_best_smallest_radius_of_a_column_is_bold(self):
        text = tiled_pcss.texel_errors(self.results(), "penumbra")
        self.assertIn("| estimator | 0.25 edges | 0.25 bars | 1 edges |", text)
        self.assertIn("| bilinear, 2 x 2 | 0.300 | 0.600 | 0.150 |", text)
        self.assertIn("smallest radius 0.5 | 0.250 | 0.500 | 0.125 |", text)
        self.assertIn("smallest radius 0.9 | **0.200** | **0.400** | **0.100** |", text)
        self.assertIn("at least 70 of them in each column", text)
        self.assertIn("is 0.0020 at most", text)

    def test_errors_of_all_receivers_have_their_own_interval(self):
        text = tiled_pcss.texel_errors(self.results(), "all")
        self.assertIn("| bilinear, 2 x 2 | 0.500 | 0.500 | 0.500 |", text)
        self.assertIn("is 0.0022 at most", text)

    def test_a_record_that_is_missing_or_doubled_is_told(self):
        results = self.results()
        with self.assertRaisesRegex(markdown.Problem, "two records"):
            tiled_pcss.texel_errors(self.results(results["records"][0]), "penumbra")
        del results["records"][0]
        with self.assertRaisesRegex(markdown.Problem, "has no bilinear"):
            tiled_pcss.texel_errors(results, "penumbra")


class FarSteps(unittest.TestCase):
    def test_a_row_has_the_error_beyond_the_shadow_distance_alone(self):
        def of(scene, steps, error, leaks):
            rings = [{"from_metres": 0.0, "to_metres": 120.0, "pixels": 900, "rmse_all": 0.9},
                     {"from_metres": 120.0, "to_metres": 150.0, "pixels": 900, "rmse_all": 0.9},
                     {"from_metres": 150.0, "to_metres": 300.0, "pixels": 30, "rmse_all": error},
                     {"from_metres": 300.0, "to_metres": 9000.0, "pixels": 10, "rmse_all": 0.0}]
            return record(f"t heightSteps={steps}", scene, by_distance=rings, leak_rate=leaks, false_shadow_rate=0.0,
                          parameters={"heightSteps": [float(steps)]})

        text = far_shadows.far_steps(results(of("a", 8, 0.2, 0.5), of("b", 8, 0.4, 0.25), of("a", 16, 0.1, 0.1),
                                             of("b", 16, 0.0, 0.0)),
                                     results(of("a", 8, 0.4, 0.75), of("a", 16, 0.2, 0.5)))
        # The second figure of 8 is the root of 3 / 4 of the first ring's.
        self.assertIn("| 8 | 0.173 | 0.346 | 0.346 | 50.0 | 25.0 | 75.0 | 0.00 | 0.00 | 0.00 | 4.0 | 4.0 |\n"
                      "| 16 | 0.087 | 0.000 | 0.173 | 10.0 | 0.0 | 50.0 |", text)


class PresetSteps(unittest.TestCase):
    def test_devices_are_paired_by_technique_and_light(self):
        figures = dict(rmse_all=0.1, bias=0.0, leak_rate=0.0, false_shadow_rate=0.0, fetches_penumbra_mean=4.0,
                       invalid=0)
        def run(device, rows):
            return {"device": device, "driver": "1", "command": "scripts/publish device", "commit": COMMIT,
                    "measured_by": f"penumbra measure --device {device}",
                    "records": [record(name, light=light, **{**figures, **own}) for name, light, own in rows]}
        first = run("one", [("a", 2.0, {"rmse_penumbra": 0.2}), ("a", 5.0, {"rmse_penumbra": 0.3}), ("b", 2.0, {}),
                            ("b", 5.0, {})])
        second = run("two", [("b", 2.0, {"fetches_mean": 4.5}), ("a", 2.0, {"rmse_penumbra": 0.21}),
                             ("a", 5.0, {"rmse_penumbra": 0.25, "leak_rate": 0.002}), ("b", 5.0, {})])
        text = measuring.device_differences(first, second)
        self.assertIn("penumbrae is 0.0500", text)
        self.assertIn("of fetches per pixel 0.500 and", text)
        self.assertIn("Commands: `penumbra measure --device one` and `penumbra measure --device two`", text)
        self.assertIn("3000 penumbra pixels", text)
        second["records"].pop()
        with self.assertRaises(markdown.Problem):
            measuring.device_differences(first, second)

    def test_front_ends_are_paired_by_technique(self):
        glslang = results(record("tent", operations_per_pixel=100.0), record("pcss", operations_per_pixel=400.0))
        fxc = results(record("pcss", operations_per_pixel=100.0, rmse_penumbra=0.15),
                      record("tent", operations_per_pixel=50.0, fetches_mean=3.0))
        with self.assertRaises(markdown.Problem):
            measuring.front_end_differences(glslang, fxc)
        fxc["front_end"] = "FXC 10"
        text = measuring.front_end_differences(glslang, fxc)
        self.assertIn("from 0.25 to 0.50. The largest difference of the RMSE in penumbrae is 0.0500.", text)
        with self.assertRaises(markdown.Problem):
            measuring.front_end_differences(glslang, {**fxc, "records": fxc["records"][:1]})

    def test_differences_are_paired_by_scene(self):
        def preset(name, scene, error):
            return record("preset-" + name, scene, rmse_penumbra=error)

        text = presets.preset_steps(results(
            preset("low", "a", 0.30), preset("low", "b", 0.10), preset("low", "c", 0.20), record("other", "a"),
            preset("high", "a", 0.28), preset("high", "b", 0.09), preset("high", "c", 0.20)))
        # The differences 0.02, 0.01 and 0 have the mean 0.01 and the standard error 0.01 / sqrt(3); t of two degrees of
        # freedom is 4.303.
        self.assertTrue(text.endswith("| from, to | 2° light |\n|:--|--:|\n| Low to High | 0.0100 ± 0.0248 (2 of 3) |"),
                        text)

    def test_one_scene_has_no_interval(self):
        text = presets.preset_steps(results(record("preset-low", rmse_penumbra=0.2),
                                            record("preset-high", rmse_penumbra=0.1)))
        self.assertIn("| Low to High | - (1 of 1) |", text)


class Masks(unittest.TestCase):
    def test_cells_are_means_over_scenes(self):
        def masked(name, scene, fetches, screen, cascade, skipped, missed, light=2.0):
            return record(name, scene, light, fetches_mean=fetches, preprocess_fetches_per_pixel=screen + cascade,
                          passes=[{"pass": "mask", "runs": "frame", "fetches_per_pixel": screen},
                                  {"pass": "map", "runs": "cascade", "fetches_per_pixel": cascade,
                                   "fetches_per_cascade": 250000.0}],
                          mask=(skipped, missed))

        measured = results(
            record("pcss", "a", fetches_mean=20.0), record("pcss", "b", fetches_mean=10.0),
            masked("pcss-masked", "a", 19.0, 2.0, 0.0, 0.25, 0.001),
            masked("pcss-masked", "b", 4.0, 2.5, 0.0, 0.75, 0.0),
            masked("pcss-conservative", "a", 12.0, 5.0, 9.0, 0.5, 0.0),
            masked("pcss-conservative", "b", 3.0, 5.5, 9.0, 0.7, 0.0))
        text = presets.masks(measured)
        self.assertIn("Not counted: 0.25 million fetches for each cascade", text)
        self.assertIn("| mean of 2 scenes | 2° light |", text)
        self.assertIn(" conservative mask | 15.0 → 13.8 → 12.8 |\n", text)
        self.assertIn(" conservative mask | 50 → 60 |\n", text)
        self.assertTrue(text.endswith(" misses, % | 0.05 → 0.00 |"), text)

    def test_two_other_techniques_are_refused(self):
        with self.assertRaises(markdown.Problem):
            presets.masks(results(record("tent-5"), record("pcss-masked")))


class BesidePcss(unittest.TestCase):
    @staticmethod
    def of(technique, operations, *errors):
        return [record(technique, scene, light, rmse_penumbra=error + light / 100.0, operations_per_pixel=operations * light)
                for light in (2.0, 5.0) for scene, error in zip("abc", errors)]

    def test_errors_are_paired_by_scene_and_operations_are_shares(self):
        text = tiled_pcss.beside_pcss(results(
            *self.of("screen-pcss-angular-24-16", 1000.0, 0.2, 0.3, 0.4),
            *self.of("pcss-angular-64-64", 2500.0, 0.1, 0.2, 0.3),
            *sorted(self.of("tiled-pcss", 300.0, 0.09, 0.2, 0.31), key=lambda one: (one["light_degrees"], one["rmse_penumbra"] < 0.25))))
        self.assertIn("| `pcss-angular-64-64` | 0.2200 | 0.2500 | 2.50 | 2.50 |", text)
        self.assertIn("| `screen-pcss-angular-24-16` | 0.3200 (+0.1000 ± 0.0000) | 0.3500 (+0.1000 ± 0.0000) | 1.00 | 1.00 |",
                      text)
        self.assertIn("| `tiled-pcss` | 0.2200 (+0.0000 ± 0.0248) | 0.2500 (+0.0000 ± 0.0248) | 0.30 | 0.30 |", text)

    def test_another_error_is_paired_in_the_same_way(self):
        own = [{**one, "overlap": {"rmse": 2.0 * one["rmse_penumbra"]}} for one in (
            *self.of("screen-pcss-angular-24-16", 1000.0, 0.2, 0.3), *self.of("pcss-angular-64-64", 2500.0, 0.1, 0.2))]
        text = tiled_pcss.beside_pcss(results(*own), figures.part_of("overlap", "rmse"), "overlap")
        self.assertIn("| technique | overlap, 2° | overlap, 5° |", text)
        self.assertIn("| `screen-pcss-angular-24-16` | 0.5400 (+0.2000 ± 0.0000) |", text)

    def test_without_what_others_are_compared_with_there_is_no_table(self):
        with self.assertRaisesRegex(markdown.Problem, "lack screen-pcss-angular-24-16 or"):
            tiled_pcss.beside_pcss(results(*self.of("tiled-pcss", 300.0, 0.1)))


class TimesOfGpu(unittest.TestCase):
    @staticmethod
    def timed(scene, milliseconds, kind="GPU time"):
        return record("tiled-pcss", scene, time_ms_median=milliseconds, time_kind=kind, rmse_penumbra=0.25,
                      false_shadow_rate=0.01,
                      passes=[{"pass": "Classify", "time_ms_median": 0.25 * milliseconds},
                              {"pass": "Resolve", "time_ms_median": 0.75 * milliseconds}])

    def test_times_stand_beside_errors(self):
        text = tiled_pcss.times_of_gpu(results(self.timed("a", 1.0), self.timed("b", 1.0)))
        self.assertIn("device, GPU time, mean of 2 scenes", text)
        self.assertIn("| `tiled-pcss` | 1.00 ± 0.00 | 0.250 ± 0.000 | 1.0 ± 0.0 |", text)
        self.assertIn("device, GPU time, a, at least 3000 penumbra pixels under each light.",
                      tiled_pcss.times_of_gpu(results(self.timed("a", 1.0))))

    def test_times_of_a_cpu_are_refused(self):
        with self.assertRaisesRegex(markdown.Problem, "not times of a GPU"):
            tiled_pcss.times_of_gpu(results(self.timed("a", 1.0, "CPU time")))
        with self.assertRaisesRegex(markdown.Problem, "not times of a GPU"):
            tiled_pcss.times_of_gpu(results(record("tiled-pcss", time_ms_median=None, time_kind="GPU time")))


class PassCounts(unittest.TestCase):
    @staticmethod
    def counted(scene, read, light=2.0):
        def one(name, more):
            return {"pass": name, "operations_per_pixel": 100.4, "fetches_per_pixel": 2.0, "bytes_read_per_pixel": more,
                    "bytes_written_per_pixel": 4.0, "dispatches": 1.0, "groups": 32400.0, "barriers_per_group": 6.0}
        return record("tiled", scene, light, passes=[one("Bounds", read), one("FilterTiles", 2.0 * read)])

    def test_each_pass_has_a_row_of_means_under_one_light(self):
        text = tiled_pcss.passes_of(results(self.counted("a", 8.0), self.counted("b", 9.0), self.counted("a", 99.0, 5.0)),
                                    "tiled", 2.0)
        self.assertIn("`tiled` under 2°, mean of 2 scenes", text)
        self.assertIn("| pass | operations per pixel | fetches per pixel | bytes read per pixel |"
                      " bytes written per pixel | dispatches | groups | barriers per group |", text)
        self.assertIn("| `Bounds` | 100 | 2.00 | 8.5 | 4.00 | 1 | 32,400 | 6 |", text)
        self.assertTrue(text.endswith("| `FilterTiles` | 100 | 2.00 | 17.0 | 4.00 | 1 | 32,400 | 6 |"), text)

    def test_older_results_are_refused(self):
        older = self.counted("a", 8.0)
        del older["passes"][1]["bytes_read_per_pixel"]
        with self.assertRaisesRegex(markdown.Problem, "lack the passes of tiled"):
            tiled_pcss.passes_of(results(older), "tiled", 2.0)


class TimeModel(unittest.TestCase):
    H200 = time_model.gpu_of("NVIDIA H200 NVL")
    # Operations and fetches per pixel, and the time over 0.8 of the operations' and 0.5 of the fetches'.
    TIMED = {"a": (1000.0, 10.0, 1.0), "b": (2000.0, 100.0, 1.0), "c": (500.0, 50.0, 1.0), "d": (4000.0, 20.0, 1.0)}

    def runs(self, timed):
        counts, times = [], []
        for name, (operations, fetches, off) in timed.items():
            for scene, more in (("x", 1.0), ("y", 1.25)):
                one = record(name, scene, operations_per_pixel=operations * more, fetches_mean=fetches * more,
                             preprocess_fetches_per_pixel=0.0, map_size=2048)
                work = time_model.work_of(one, self.H200)
                counts.append(one)
                times.append({**one, "time_ms_median": off * (0.8 * work.operations + 0.5 * work.fetches) +
                              time_model.DISPATCH_MS + time_model.map_ms(one, self.H200)})
        gone = record("gone", "x", time_ms_median=1.0, map_size=2048)  # whose operations nobody can count any more
        return {**results(*times, gone), "device": "NVIDIA H200"}, results(*counts)

    def test_a_gpu_whose_peak_rate_is_not_known_is_refused(self):
        times, counts = self.runs(self.TIMED)
        with self.assertRaisesRegex(markdown.Problem, "peak rate of 'Other' is not known"):
            time_model.fit({**times, "device": "Other"}, counts)

    def test_both_factors_are_found(self):
        fitted = time_model.fit(*self.runs(self.TIMED))
        self.assertAlmostEqual(fitted.factors.operations, 0.8, 4)
        self.assertAlmostEqual(fitted.factors.fetches, 0.5, 4)
        self.assertAlmostEqual(fitted.deviation, 0.0, 4)
        self.assertEqual(fitted.freedom, 2)
        for ratio in time_model.left_out(*self.runs(self.TIMED)).values():
            self.assertAlmostEqual(ratio, 1.0, 3)

    # All have the same share, so that one factor is left: two take twice as long as the others.
    def test_the_error_is_that_of_another_technique(self):
        timed = {name: (1000.0, 10.0, 2.0 if name in "ab" else 1.0) for name in "abcd"}
        fitted = time_model.fit(*self.runs(timed))
        self.assertAlmostEqual(fitted.deviation, 0.5 * math.log(2.0) * math.sqrt(4.0 / 2.0))
        alike = time_model.work_of(record("z", operations_per_pixel=500.0, fetches_mean=5.0,
                                          preprocess_fetches_per_pixel=0.0), self.H200)
        self.assertAlmostEqual(fitted.error(alike), 4.303 * fitted.deviation * math.sqrt(1.25))
        ratios = time_model.left_out(*self.runs(timed))
        self.assertAlmostEqual(ratios["a"], 2.0 ** (1.0 / 3.0) / 2.0)
        self.assertAlmostEqual(ratios["c"], 2.0 ** (2.0 / 3.0))

    def test_work_of_another_kind_is_less_certain(self):
        fitted = time_model.fit(*self.runs({**self.TIMED, "d": (4000.0, 20.0, 1.5)}))
        errors = [fitted.error(time_model.Work(1.0, fetches)) for fetches in (2.0, 8.0, 32.0)]
        self.assertEqual(errors, sorted(errors))
        self.assertLess(errors[0], errors[1])

    def test_two_techniques_say_nothing_of_a_third(self):
        with self.assertRaisesRegex(markdown.Problem, "fewer than three"):
            time_model.fit(*self.runs({"a": (1.0, 1.0, 1.0), "b": (1.0, 2.0, 1.0)}))

    def test_a_prediction_has_memory_and_dispatches(self):
        gpu = time_model.Gpu("g", 2.0, 1000.0, 100.0)
        one = record("preset-low", operations_per_pixel=500.0, fetches_mean=75.0, preprocess_fetches_per_pixel=25.0,
                     map_size=2048, passes=[{"pass": "A", "texels_written_per_pixel": 1.0},
                                            {"pass": "B", "texels_written_per_pixel": 0.25}])
        fitted = time_model.Fit(time_model.Work(2.0, 0.5), math.log(2.0) / 4.303 / math.sqrt(1.25), 2, (0.5,) * 4)
        rest = 4.0 * (2.5 * 1920 * 1080 + 2048 ** 2) / 1e8 + 2 * time_model.DISPATCH_MS
        low, middle, high = time_model.predicted_ms(one, gpu, fitted)
        # 500 operations of 2073600 pixels at 10^12 a second take 1.0368 ms, 100 fetches at 10^12 0.20736.
        self.assertAlmostEqual(middle - rest, 2.0736 + 0.10368)
        self.assertAlmostEqual(low - rest, 0.5 * (middle - rest))
        self.assertAlmostEqual(high - rest, 2.0 * (middle - rest))

    def test_a_time_takes_the_place_of_a_prediction(self):
        times, counts = self.runs(self.TIMED)
        presets = results(*(record("preset-low", scene, light_degrees=2.0, operations_per_pixel=500.0, fetches_mean=75.0,
                                   preprocess_fetches_per_pixel=0.0, map_size=2048, passes=[]) for scene in "xy"))
        self.assertNotIn("measured |", time_model.predictions(presets, times, counts, 2.0))
        times["records"] += [record("preset-low", scene, light_degrees=2.0, time_ms_median=ms, map_size=2048)
                             for scene, ms in (("x", 1.0), ("y", 3.0))]
        text = time_model.predictions(presets, times, counts, 2.0)
        self.assertIn("| `preset-low` | 2.00, measured | ", text)
        self.assertEqual(text.count("2.00, measured"), 1)
        self.assertIn("The NVIDIA H200 was timed, over 2 scenes; the other columns are predictions.", text)


class MeasureGpu(unittest.TestCase):
    def test_a_dry_run_draws_small_pictures_and_leaves_published_results_alone(self):
        script = runpy.run_path(str(figures.ROOT / "scripts" / "measure-gpu"))
        commands = script["small_commands"]("Some GPU")
        self.assertEqual(len(commands), len(script["STUDIES"]))
        for command, size in zip(commands, ("96x54", "192x108")):
            self.assertIn(f" --size {size} ", command)
            self.assertIn(" --timing-repeats 1 ", command)
            self.assertTrue(command.endswith(f"--output build/measure-gpu/gpu-times/{size}"), command)
            for name in ("preset-low", "preset-medium", "preset-high", "preset-ultra", "pcss-angular-24-16",
                         "pcss-angular-64-64"):
                self.assertIn(name, command)


class ScreenFigures(unittest.TestCase):
    def test_means_over_scenes_of_all_passes(self):
        text = screen_passes.screen_figures(results(
            record("t", "a", mask=(0.2, 0.01), shimmer=(0.1, 0.2), preprocess_fetches_per_pixel=1.0),
            record("t", "b", mask=(0.4, None), shimmer=(0.3, None), rmse_penumbra=0.2, penumbra_pixels=2017),
            record("plain", "a", rmse_penumbra=None, fetches_mean=None)))
        self.assertTrue(text.startswith(
            "device, mean of 2 scenes, at least 2017 penumbra pixels per scene and light; ± is half the width of the"
            " 95 % confidence interval over the scenes; where it is cut off at 0 or at the largest possible value, [a,"
            " b] gives its"
            f" ends. Command: `penumbra measure --made`, at commit {COMMIT}.\n"), text)
        # The interval of two values is 12.706 times half their difference; here it goes below 0.
        self.assertIn("| t | 0.150 [0, 0.785] | 4.5 [0, 10.9] | 30 | 1.00 | 0.200 | 0.200 |", text)
        self.assertIn("| plain | - | - | - | - | - | - |", text)


if __name__ == "__main__":
    unittest.main()
