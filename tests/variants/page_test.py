"""The tables of what a player contains say what their files say."""
import importlib.machinery
import importlib.util
import json
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
loader = importlib.machinery.SourceFileLoader("page", str(HERE / "page"))
page = importlib.util.module_from_spec(importlib.util.spec_from_loader("page", loader))
loader.exec_module(page)

PRESETS = {"programs": 1300, "presets": [{"name": "preset-low", "programs": [
    {"pass": "P", "keywords": ["_A", "_B"]}, {"pass": "Q", "keywords": []}]}]}
COUNTS = {"urp": "14.0.0", "projects": {"desktop": [
    {"shader": "Universal Render Pipeline/Lit", "pass": "Forward",
     "stages": [{"stage": "vertex", "variants": 4, "what_if": 3},
                {"stage": "fragment", "variants": 4000, "what_if": 3000}]},
    {"shader": "Universal Render Pipeline/Lit", "pass": "Depth",
     "stages": [{"stage": "vertex", "variants": 2, "what_if": 2},
                {"stage": "fragment", "variants": 5, "what_if": 5}]}]}}


class Page(unittest.TestCase):
    def test_says_what_the_files_say(self):
        text = page.PAGE.read_text()
        parts = page.parts(json.loads(page.PRESETS.read_text()), json.loads(page.RECEIVERS.read_text()))
        self.assertEqual(text, page.written(text, parts), "run tests/variants/page")

    def test_a_preset_s_programs_are_named_and_counted(self):
        text = page.presets(PRESETS)
        self.assertIn("| Low | `P` `_A` `_B`, `Q` | 2 |", text)
        self.assertIn("| without stripping | every pass with every keyword set | 1300 |", text)

    def test_what_is_added_is_the_difference_over_all_passes(self):
        self.assertIn("| desktop | Lit | `Forward` | 5 | 1 | 3,005 | 1,000 |", page.receivers(COUNTS))

    def test_the_command_is_the_one_that_counts(self):
        command = " ".join(page.receivers_command("PROJECT", "DIR"))
        self.assertIn(f"`penumbra {command}`", page.receivers(COUNTS))
        for project in page.PROJECTS:
            settings = command.split("--stripping ")[1].split()[0].replace("PROJECT", project)
            self.assertTrue((page.ROOT / settings).is_file(), settings)

    def test_only_the_screen_keyword_is_the_difference(self):
        counts = json.loads(page.RECEIVERS.read_text())
        self.assertEqual(counts["condition"], page.CONDITION)
        self.assertEqual(list(counts["projects"]), list(page.PROJECTS))


if __name__ == "__main__":
    unittest.main()
