"""The page's tables of shares, and the runner counts as the page claims."""
import importlib.machinery
import importlib.util
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "tools" / "pages"))
import validating as page  # noqa: E402
from figures import read_json  # noqa: E402


def script(name):
    loader = importlib.machinery.SourceFileLoader(name, str(HERE / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


run = script("run")


def record(status, target="spirv", place="0.0", message="", file="/r/A.shader"):
    diagnostics = [{"file": "/r/Inc/B.hlsl", "line": 7, "severity": "error", "message": message}] if message else []
    return {"file": file, "shader": "S", "pass": place, "status": status, "target": target, "keywords": [],
            "messages": diagnostics}


def sum_up(*records):
    return run.sum_up(list(records), [(Path("/r"), "")])


class Page(unittest.TestCase):
    def test_first_and_last_run_are_of_the_same_repositories(self):
        listed = [entry["repository"] for entry in read_json(HERE / "third_party_shaders.json")["repositories"]]
        self.assertEqual([entry["repository"] for entry in read_json(HERE / "first_run.json")["results"]], listed)
        self.assertEqual([entry["repository"] for entry in read_json(HERE / "last_run.json")["third_party"]], listed)

    def test_no_cause_goes_without_an_explanation(self):
        last = {"third_party": [{"repository": "o/n", "causes": [
            {"message": "no 'f'", "targets": ["spirv"], "blocks": 2, "example": "a:1", "shader": "s"}]}], "urp": [], "lighting": []}
        fits = {"message": "no 'f'", "kind": "k", "explanation": "e"}
        self.assertIn("| k | 1 | 2 |", page.causes(last, [fits]))
        for explanations in ([], [{**fits, "message": "other"}], [fits, fits], [{**fits, "where": "p/q"}],
                             [fits, {**fits, "message": "gone"}]):
            with self.assertRaises(page.Problem):
                page.causes(last, explanations)


class FrontEnds(unittest.TestCase):
    def note(self, message):
        return {"file": "/r/Inc/B.hlsl", "line": 7, "severity": "note", "rule": "from-bytecode",
                "message": "FXC accepts this, and glslang does not: " + message}

    def compared(self):
        def of(status, target, keywords, message=""):
            return {**record(status, target, message=message), "keywords": keywords, "entry": "Frag", "stage": "fragment"}

        return run.compare_front_ends(
            [of("passed", "spirv", []), of("passed", "d3d11", []),
             of("passed", "spirv", ["A"]), of("failed", "d3d11", ["A"], "X3004: undeclared identifier 'a'"),
             of("passed", "spirv", ["B"]), of("failed", "d3d11", ["B"], "X3004: undeclared identifier 'b'"),
             {**of("passed", "spirv", ["C"]), "messages": [self.note("no \"c\"")]}, of("passed", "d3d11", ["C"]),
             {**of("unchecked", "spirv", ["F"]), "messages": [self.note("no \"f\"")]}, of("passed", "d3d11", ["F"]),
             of("failed", "spirv", ["D"], "no"), of("failed", "d3d11", ["D"], "no"),
             of("failed", "spirv", ["E"], "cannot find 'E'"), of("passed", "d3d11", ["E"])], [(Path("/r"), "")])

    def test_variants_that_one_alone_refuses_are_counted_by_cause(self):
        result = self.compared()
        self.assertEqual((result["variants"], result["accepted_by_fxc"], result["passed_by_us"],
                          result["from_bytecode"]), (6, 3, 3, 1))
        self.assertEqual(result["false_passes"], [{"message": "X3004: undeclared identifier '...'", "variants": 2,
                                                   "says": "X3004: undeclared identifier 'a'", "example": "Inc/B.hlsl:7"}])
        self.assertEqual([(cause["message"], cause["variants"]) for cause in result["false_refusals"]],
                         [("no '...'", 2)])

    def test_the_page_adds_up_repositories(self):
        data = {"fxc": "FXC 1", "third_party": [{"repository": "o/n", **self.compared()}],
                "urp": [{"version": "9", **self.compared()}]}
        self.assertIn("| 1 repositories | 6 | 3 (50.0 %) | 3 (50.0 %) | 2 | 2 |\n| URP 9 | 6 |", page.front_ends(data))


class Judged(unittest.TestCase):
    def test_of_the_blocks_that_fxc_accepts_those_that_reach_all_targets_count(self):
        def note(status, target, place):
            return {**record(status, target, place), "messages": [
                {"file": "/r/B.hlsl", "line": 7, "severity": "note", "rule": "from-bytecode", "message": "no"}]}

        result = run.sum_up_judged(
            [record("passed", "d3d11"), record("passed"), record("passed", "d3d11", "0.1"), note("passed", "spirv", "0.1"),
             record("failed", "essl310", "0.1", "no ES"), record("passed", "d3d11", "0.2"), note("unchecked", "spirv", "0.2"),
             record("failed", "d3d11", "0.3", "X1"), record("failed", place="0.3", message="X1"),
             record("failed", "d3d11", "0.4", "cannot find 'x'; tried /y"), record("unchecked", place="0.5"),
             record("passed", place="0.6")],
            [(Path("/r"), "")])
        self.assertEqual(result["blocks"], {"total": 7, "editor_only": 1, "include_missing": 1, "other_apis": 1,
                                            "counted": 4, "accepted_by_fxc": 3, "spirv": 2, "all_targets": 1, "from_bytecode": 2})
        self.assertEqual(result["refused_by_fxc"], [{"message": "X1", "blocks": 1}])
        self.assertEqual(result["lost"], [{"message": "no", "blocks": 1}, {"message": "no ES", "blocks": 1}])


class Sums(unittest.TestCase):
    def test_a_block_passes_when_all_its_variants_do(self):
        blocks = sum_up(record("passed"), record("passed", "hlsl50"), record("passed", place="0.1"),
                        record("failed", place="0.1", message="no"), record("unreached", "hlsl50", "0.1"))["blocks"]
        self.assertEqual(blocks, {"total": 2, "editor_only": 0, "include_missing": 0, "counted": 2, "spirv": 1,
                                  "all_targets": 1, "all_but_hlsl": 1})

    def test_one_target_that_fails_leaves_the_others(self):
        blocks = sum_up(record("passed"), record("failed", "hlsl50", message="no geometry"),
                        record("failed", "essl310", "0.1", "no"))["blocks"]
        self.assertEqual((blocks["spirv"], blocks["all_but_hlsl"], blocks["all_targets"]), (2, 1, 0))

    def test_a_program_that_cannot_be_read_fails(self):
        result = sum_up(record("failed", "source", message="no such function"))
        self.assertEqual((result["blocks"]["spirv"], result["causes"][0]["targets"]), (0, ["spirv"]))

    def test_blocks_without_their_includes_are_left_out(self):
        blocks = sum_up(record("unchecked"), record("failed", place="0.1", message="cannot find 'x.hlsl'; tried /y"),
                        record("passed", place="0.2"))["blocks"]
        self.assertEqual((blocks["total"], blocks["editor_only"], blocks["include_missing"], blocks["counted"],
                          blocks["spirv"]), (3, 1, 1, 1, 1))

    def test_causes_are_told_once_with_an_example(self):
        causes = sum_up(record("failed", message="bad %12 = x\nmore"),
                        record("failed", "hlsl50", "0.1", "bad %7 = x"))["causes"]
        self.assertEqual(causes, [{"message": "bad %N = x", "targets": ["hlsl50", "spirv"], "blocks": 2,
                                   "example": "Inc/B.hlsl:7", "shader": "A.shader"}])

    def test_compute_files_are_no_blocks(self):
        self.assertEqual(sum_up(record("failed", file="/r/A.compute", message="no"))["blocks"]["total"], 0)

    def test_its_user_gives_project_and_packages(self):
        entry = {"project": True, "packages": {"com.a": "Assets/A"}}
        self.assertEqual(run.what_its_user_gives(entry, Path("/r")),
                         [["--package-root", "com.a=/r/Assets/A"], ["--project", "/r"]])
        self.assertEqual(run.what_its_user_gives({}, Path("/r")), [["/r"]])


if __name__ == "__main__":
    unittest.main()
