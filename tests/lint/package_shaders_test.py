"""The lint rules are silent on the package's programs and on its samples', but for srp-batcher in the
two shaders that draw casters with the materials of other shaders, whose layout they cannot know."""
import json
import os
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests"))
from validate_report import results  # noqa: E402

PROGRAM = os.environ["PENUMBRA_PROGRAM"]
STAND_INS = {"Shaders": ROOT / "tools/programs/shaders/unity", "Samples~": ROOT / "tests/samples/unity"}


class PackageShaders(unittest.TestCase):
    def test_no_rule_speaks(self):
        for folder, packages in STAND_INS.items():
            with self.subTest(folder=folder):
                roots = [word for place in packages.iterdir() for word in ("--package-root", f"{place.name}={place}")]
                result = subprocess.run([PROGRAM, "validate", ROOT / folder, "--target", "spirv", "--fxc", "off", "--sample", "1", *roots,
                                         "--package-root", f"com.penumbra.shadows={ROOT}", "--no-cache", "--disable-rule", "srp-batcher",
                                         "--format", "json"],
                                        capture_output=True, text=True)
                self.assertEqual(result.returncode, 0, result.stderr)
                report = json.loads(result.stdout)
                self.assertIn("divergent-derivative", report["rules"])
                self.assertGreater(len(results(report)), 10)
                said = [message for variant in results(report) for message in variant["messages"] if "rule" in message]
                self.assertEqual(said, [])


if __name__ == "__main__":
    unittest.main()
