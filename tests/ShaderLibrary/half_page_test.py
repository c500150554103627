"""The page says what the file of the last run says; lines of a run are read, and those of two runs refused."""
import importlib.machinery
import importlib.util
import json
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
loader = importlib.machinery.SourceFileLoader("half_page", str(HERE / "half_page"))
page = importlib.util.module_from_spec(importlib.util.spec_from_loader("half_page", loader))
loader.exec_module(page)

LINE = "half: {} | texels | 0.0625 | {} | 40000 cases, two directions of depth | {}\n"


class HalfPage(unittest.TestCase):
    def test_says_what_the_last_run_says(self):
        self.assertIn(page.figures(json.loads(page.RESULTS.read_text())), page.PAGE.read_text(), f"run {page.COMMAND}")

    def test_lines_are_read(self):
        results = page.take("[ RUN ]\n" + LINE.format("Near", 0.01, "a") + LINE.format("Far, place", "inf", "a"))
        self.assertEqual([(page.is_fit(one), one["largest"]) for one in results["functions"]], [(True, 0.01), (False, None)])
        self.assertIn("| `Far`, place | **unfit** | texels | not finite | 0.062 |", page.figures(results))

    def test_lines_of_two_devices_are_refused(self):
        with self.assertRaises(page.Problem):
            page.take(LINE.format("Near", 0.01, "a") + LINE.format("Far", 0.01, "b"))

    def test_a_run_without_lines_is_refused(self):
        with self.assertRaises(page.Problem):
            page.take("[ RUN ]\n")


if __name__ == "__main__":
    unittest.main()
