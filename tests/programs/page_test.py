"""The page says what the file of the last run says, and half a run is not taken for a whole one."""
import importlib.machinery
import importlib.util
import json
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
loader = importlib.machinery.SourceFileLoader("page", str(HERE / "page"))
page = importlib.util.module_from_spec(importlib.util.spec_from_loader("page", loader))
loader.exec_module(page)

HALF = ("{} programs on 4 sets of inputs each, seeds from {} on, 3 more not run; differences: 0, "
        "largest distance of two floats: {} ULP; device: llvmpipe\n")


class Page(unittest.TestCase):
    def test_says_what_the_last_run_says(self):
        self.assertIn(page.figures(json.loads(page.RESULTS.read_text())), page.PAGE.read_text(), f"run {page.COMMAND}")

    def test_halves_are_added(self):
        results = page.take("[ RUN ]\n" + HALF.format(250, 1, 1) + HALF.format(250, 1000001, 2))
        self.assertEqual((results["programs"], results["not_run"], results["most_ulps"]), (500, 6, 2))
        self.assertEqual(results["first_seeds"], [1, 1000001])

    def test_half_a_run_is_refused(self):
        with self.assertRaises(page.Problem):
            page.take(HALF.format(250, 1, 1))


if __name__ == "__main__":
    unittest.main()
