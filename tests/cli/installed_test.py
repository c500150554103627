"""Moves the folder that `cmake --install` has filled: the program finds its shaders there, all of them, and a project
finds the C++ library, as the page on installing shows it."""
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs" / "cpp-library.md"
CMAKE = os.environ["PENUMBRA_CMAKE"]
READ_AT_RUN_TIME = (".hlsl", ".shader", ".technique.json")
ENVIRONMENT = {key: value for key, value in os.environ.items() if key != "PENUMBRA_ROOT"}


def block(language):
    return re.search(rf"^```{language}\n(.*?)^```$", PAGE.read_text(), re.MULTILINE | re.DOTALL)[1]


def shaders(root, *folders):
    return {str(file.relative_to(root)) for folder in folders for file in (root / folder).rglob("*")
            if file.name.endswith(READ_AT_RUN_TIME)}


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = Path(scratch.name)
        subprocess.run([CMAKE, "--install", os.environ["PENUMBRA_BUILD"], "--prefix", cls.scratch / "first"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.prefix = cls.scratch / "moved"
        shutil.move(cls.scratch / "first", cls.prefix)
        cls.data = cls.prefix / "share" / "penumbra"

    def run_program(self, *arguments, code=0, **variables):
        result = subprocess.run([self.prefix / "bin" / "penumbra", *arguments], cwd=self.scratch,
                                env=ENVIRONMENT | variables,
                                capture_output=True, text=True)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def test_every_shader_is_there(self):
        expected = shaders(ROOT, "ShaderLibrary", "Shaders", "tools")
        self.assertGreater(len(expected), 40)
        self.assertEqual(shaders(self.data, "."), expected)

    def test_the_installed_library_is_valid(self):
        unity = self.data / "tools" / "programs" / "shaders" / "unity"
        roots = [argument for name in ("core", "universal") for argument in
                 ("--package-root", f"com.unity.render-pipelines.{name}={unity}/com.unity.render-pipelines.{name}")]
        self.assertIn(" 0 failed", self.run_program("validate", self.data / "Shaders", "--no-cache", "--target", "spirv", *roots))

    def test_the_program_reads_the_installed_library_and_no_other(self):
        library = self.data / "ShaderLibrary" / "Shadows.hlsl"
        text = library.read_text()
        self.addCleanup(library.write_text, text)
        library.write_text("#error the installed one\n" + text)
        shader = self.scratch / "Mine.hlsl"
        shader.write_text('#include "Packages/com.penumbra.shadows/ShaderLibrary/Shadows.hlsl"\n'
                          "float4 Main() : SV_Target { return 0; }\n")
        output = self.run_program("validate", shader, "--no-cache", "--entry", "Main", "--stage", "fragment", code=1)
        self.assertRegex(output, rf"{re.escape(str(library))}:1:.*the installed one")

    def test_a_root_without_the_library_is_an_error(self):
        said = self.run_program("validate", "--target", "spirv", code=3, PENUMBRA_ROOT=str(self.scratch))
        self.assertIn(f"the shader library was not found; tried: {self.scratch}\n", said)

    def test_the_program_measures(self):
        report = self.run_program("measure", "--size", "64x36", "--scene", "contact-boxes", "--light", "2", "--seeds", "1",
                                  "--reference-samples", "32", "--timing-repeats", "0", "--no-split", "--quiet",
                                  "--technique", "preset-high")
        self.assertEqual([record["technique"] for record in json.loads(report)["records"]], ["preset-high"])

    def test_the_pages_project_finds_the_library(self):
        project, build = self.scratch / "project", self.scratch / "build"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(block("cmake"))
        (project / "cascades.cpp").write_text(block("cpp"))
        options = json.loads(os.environ["PENUMBRA_CMAKE_OPTIONS"])
        for command in ([CMAKE, "-S", project, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", *options],
                        [CMAKE, "--build", build]):
            result = subprocess.run(command, capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        printed = subprocess.run([build / "cascades"], check=True, capture_output=True, text=True).stdout
        self.assertRegex(printed, r"\A(depth to radial 0\.\d+\n){4}\Z")


if __name__ == "__main__":
    unittest.main()
