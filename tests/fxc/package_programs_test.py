"""Every program of the package, with every keyword set that a build can contain, and of its samples, with some of their thousands,
through FXC, which is Unity's compiler: no error and no warning, with the macros of Direct3D 11.

URP's include files are stand-ins of the tests; with PENUMBRA_URP_PACKAGES, a folder that contains
com.unity.render-pipelines.core and .universal, they are URP's own."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = os.environ["PENUMBRA_PROGRAM"]
URP = os.environ.get("PENUMBRA_URP_PACKAGES")
STAND_INS = {"Shaders": ROOT / "tools/programs/shaders/unity", "Samples~": ROOT / "tests/samples/unity"}
APIS = ("d3d11",)


def package_roots(folder):
    parts = ["core", "universal"] + (["universal-config"] if URP else [])
    found = Path(URP) if URP else STAND_INS[folder]
    roots = {f"com.unity.render-pipelines.{part}": found / f"com.unity.render-pipelines.{part}" for part in parts}
    return {name: place for name, place in roots.items() if place.exists()} | {"com.penumbra.shadows": ROOT}


def is_ours(message):
    """URP's files have warnings of their own."""
    return not URP or not str(message["file"]).startswith(URP)


class PackagePrograms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = Path(scratch.name)
        environment = {key: value for key, value in os.environ.items() if key != "PENUMBRA_FXC"}
        cls.environment = environment
        probe = cls.scratch / "Probe.compute"
        probe.write_text("#pragma kernel Main\n[numthreads(1, 1, 1)] void Main() {}\n")
        result = subprocess.run([PROGRAM, "validate", probe, "--target", "d3d11", "--no-cache"], env=environment,
                                capture_output=True, text=True)
        if result.returncode == 3:
            raise unittest.SkipTest(result.stderr.strip())

    def variants(self, folder, api, most):
        roots = [word for name, place in package_roots(folder).items() for word in ("--package-root", f"{name}={place}")]
        # Flagship's kernels take FXC minutes: they are compiled by hand until that is mended.
        skipped = ("--skip", "*Flagship*", "--time-limit", "120") if folder == "Shaders" else ()
        report = self.scratch / "report.json"
        result = subprocess.run([PROGRAM, "validate", ROOT / folder, "--target", "d3d11", "--api", api, *roots, "--stripping",
                                 ROOT / "tests/samples/both_eyes.json", "--limit", "100000", "--sample", str(most), *skipped, "--format", "json", "-o", report,
                                 "--cache", self.scratch / "cache"],
                                env=self.environment, capture_output=True, text=True)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return json.loads(report.read_text())["variants"]

    def check(self, folder, least, most=0):
        for api in APIS:
            with self.subTest(api=api):
                variants = self.variants(folder, api, most)
                self.assertGreater(len(variants), least)
                said = {f"{message['file']}:{message.get('line', 0)}: {message['severity']}: {message['message']}"
                        for variant in variants for message in variant.get("diagnostics", ()) if is_ours(message)}
                self.assertEqual(said, set())

    def test_the_package_compiles_without_a_message(self):
        self.check("Shaders", 400)

    def test_the_samples_compile_without_a_message(self):
        self.check("Samples~", 20, most=4)


if __name__ == "__main__":
    unittest.main()
