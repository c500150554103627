"""The page of distance fields says what its results say."""
import importlib.machinery
import importlib.util
import json
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
loader = importlib.machinery.SourceFileLoader("page", str(HERE / "page"))
page = importlib.util.module_from_spec(importlib.util.spec_from_loader("page", loader))
loader.exec_module(page)


class Page(unittest.TestCase):
    def setUp(self):
        self.results = json.loads(page.RESULTS.read_text())

    def test_says_what_the_results_say(self):
        text = page.PAGE.read_text()
        self.assertEqual(text, page.written(text, page.parts(self.results)), "run tests/bake/page")

    def test_a_record_that_is_missing_or_doubled_is_told(self):
        for records in (self.results["marches"][1:], self.results["marches"] + self.results["marches"][:1]):
            with self.assertRaises(page.Problem):
                page.parts({**self.results, "marches": records})

    def test_figures_are_of_their_shape_width_and_march(self):
        first = self.results["marches"][0]
        line = next(line for line in page.march_errors(self.results).splitlines() if line.startswith(f"| {first['shape']} |"))
        self.assertIn(page.MARCHES[first["march"]], line)
        self.assertEqual(line.split(" | ")[2], f"{first['rmse']:.3f}")


if __name__ == "__main__":
    unittest.main()
