"""The pages of speeds say what the results file says, and nothing of the machine's folders gets into it."""
import importlib.machinery
import importlib.util
import json
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
loader = importlib.machinery.SourceFileLoader("page", str(HERE / "page"))
page = importlib.util.module_from_spec(importlib.util.spec_from_loader("page", loader))
loader.exec_module(page)

RAW = {"context": {"date": "2026-01-02T03:04:05+00:00", "host_name": "builder", "executable": "/builds/someone/b",
                   "num_cpus": 2},
       "benchmarks": [{"run_name": "techniques/variants:8/x", "run_type": "iteration", "shell_ms": 99.0},
                      {"run_name": "techniques/variants:8/x", "aggregate_name": "median", "variants": 8.0,
                       "shell_ms": 60.0, "cold_ms": 15.0, "cold_ratio": 4.0, "cold_cpu_ratio": 4.5, "real_time": 7.0}]}


class Page(unittest.TestCase):
    def test_says_what_the_results_say(self):
        for path, texts in page.parts(json.loads(page.RESULTS.read_text())).items():
            text = path.read_text()
            self.assertEqual(text, page.written(text, texts), "run tests/benchmarks/page")

    def test_medians_are_taken_and_the_machine_is_not_told(self):
        results = page.take(RAW)
        self.assertEqual(results["sets"], [{"name": "techniques", "variants": 8.0, "shell_ms": 60.0, "cold_ms": 15.0,
                                            "cold_ratio": 4.0, "cold_cpu_ratio": 4.5}])
        self.assertEqual((results["threads"], results["date"]), (2, "2026-01-02"))
        self.assertNotIn("someone", json.dumps(results))
        self.assertNotIn("builder", json.dumps(results))

    def test_one_run_alone_is_refused(self):
        with self.assertRaises(page.Problem):
            page.take({**RAW, "benchmarks": RAW["benchmarks"][:1]})


if __name__ == "__main__":
    unittest.main()
