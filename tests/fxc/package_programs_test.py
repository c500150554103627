"""FXC, Unity's compiler, takes every program of the package with every keyword set that a build can contain, and those
of its samples with some of their thousands, without an error or a warning: with the macros of each graphics API and for
both eyes.

URP's include files are stand-ins of the tests. PENUMBRA_URP_PACKAGES lists folders with com.unity.render-pipelines.core and
.universal, separated like those of PATH: then they are URP's own of each folder, too, and the stand-ins are held against
them."""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests"))
from validate_report import results  # noqa: E402

PROGRAM = os.environ["PENUMBRA_PROGRAM"]
URP = [Path(folder) for folder in os.environ.get("PENUMBRA_URP_PACKAGES", "").split(os.pathsep) if folder]
STAND_INS = {"Shaders": ROOT / "tools/programs/shaders/unity", "Samples~": ROOT / "tests/samples/unity"}
# The ways in which each API draws both eyes at once, for which a build has keyword sets. Many texts are the same for
# all APIs: the cache has their answers from the first.
APIS = {"d3d11": ["instancing"], "vulkan": ["instancing", "multiview"], "metal": ["instancing"], "glcore": ["instancing"],
        "gles3": ["multiview"], "switch": []}
PARTS = [f"com.unity.render-pipelines.{part}" for part in ("core", "universal", "universal-config")]


def declared(files):
    """Name and number of parameters of macros and functions that begin a line; each number where some have defaults."""
    names = set()
    for file in files:
        text = file.read_text(errors="replace").replace("\\\n", " ")
        for name, parameters in re.findall(r"^[ \t]*#[ \t]*define[ \t]+(\w+)(\([^)]*\))?", text, re.M):
            names.add((name, count_of(parameters)))
        for name, parameters in re.findall(r"^[ \t]*(?:inline[ \t]+)?(?:(?:void|bool|uint|int|float|half|real)\d?(?:x\d)?|Light)"
                                           r"[ \t]+(\w+)(\([^){;]*\))\s*\{", text, re.M):
            count = count_of(parameters)
            names.update((name, count - left_out) for left_out in range(parameters.count("=") + 1))
    return names


def count_of(parameters):
    inside = parameters.strip("()").strip()
    return inside.count(",") + 1 if inside and inside != "void" else 0


def is_urps(name):
    return not name.startswith(("PENUMBRA_", "STANDS_IN_", "StandsIn", "Penumbra")) and not name.endswith("_INCLUDED")


class PackagePrograms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = Path(scratch.name)
        # Other tests do without FXC.
        cls.environment = {key: value for key, value in os.environ.items() if (key, value) != ("PENUMBRA_FXC", "off")}
        probe = cls.scratch / "Probe.compute"
        probe.write_text("#pragma kernel Main\n[numthreads(1, 1, 1)] void Main() {}\n")
        result = subprocess.run([PROGRAM, "validate", probe, "--target", "d3d11", "--no-cache"], env=cls.environment,
                                capture_output=True, text=True)
        if result.returncode == 3:
            raise unittest.SkipTest(result.stderr.strip())

    def variants(self, folder, packages, api, most):
        roots = {part: packages / part for part in PARTS if (packages / part).exists()}
        roots["com.penumbra.shadows"] = ROOT
        given = [word for name, place in roots.items() for word in ("--package-root", f"{name}={place}")]
        report = self.scratch / "report.json"
        stripping = self.scratch / "stripping.json"
        stripping.write_text(json.dumps({"urp": {"xr": APIS[api]}}))
        result = subprocess.run(
            [PROGRAM, "validate", ROOT / folder, "--target", "d3d11", "--api", api, *given, "--stripping",
             stripping, "--limit", "100000", "--sample", str(most), "--format", "json", "-o", report,
             "--cache", self.scratch / "cache"], env=self.environment, capture_output=True, text=True)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return results(json.loads(report.read_text()))

    def check(self, folder, least, most=0):
        for packages in [STAND_INS[folder], *URP]:
            for api in APIS:
                with self.subTest(packages=str(packages), api=api):
                    variants = self.variants(folder, packages, api, most)
                    self.assertGreater(len(variants), least)
                    # A pass may leave out the API by exclude_renderers.
                    unchecked = [variant for variant in variants if variant["status"] != "passed" and
                                 not variant.get("reason", "").startswith("only_renderers or exclude_renderers")]
                    self.assertEqual(unchecked, [])
                    # URP's files have warnings of their own.
                    said = {f"{message['file']}:{message.get('line', 0)}: {message['severity']}: {message['message']}"
                            for variant in variants for message in variant["messages"]
                            if message["severity"] == "error" or packages not in URP or not str(message["file"]).startswith(str(packages))}
                    self.assertEqual(said, set())

    def test_the_package_compiles_without_a_message(self):
        self.check("Shaders", 150)

    def test_the_samples_compile_without_a_message(self):
        self.check("Samples~", 10, most=4)


class StandIns(unittest.TestCase):
    @unittest.skipUnless(URP, "PENUMBRA_URP_PACKAGES names no folder of URP's packages")
    def test_every_macro_and_function_is_one_of_urps(self):
        files = [file for place in STAND_INS.values() for part in PARTS for file in (place / part).rglob("*.hlsl")]
        ours = {one for one in declared(files) if is_urps(one[0])}
        self.assertGreater(len(ours), 30)
        # The library defines what a version of URP lacks.
        replaced = declared([ROOT / "ShaderLibrary/Platform/Platform.hlsl"])
        self.assertGreater(len(replaced), 20)
        for packages in URP:
            theirs = declared(file for part in PARTS[:2] for file in (packages / part / "ShaderLibrary").rglob("*.hlsl"))
            known = {name for name, _ in theirs}
            self.assertEqual(ours - theirs, set(), packages)
            self.assertEqual({one for one in replaced if one[0] in known} - theirs, set(), packages)

    def test_what_is_declared(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "A.hlsl"
            file.write_text("#define A\n# define B(x, y) x \\\n  y\nfloat3 C(float a,\n  float b = 1)\n{\n}\nint d = C(1, 2);\n")
            self.assertEqual(declared([file]), {("A", 0), ("B", 2), ("C", 1), ("C", 2)})


if __name__ == "__main__":
    unittest.main()
