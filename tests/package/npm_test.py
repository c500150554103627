"""npm itself would pack the same files; it reads the folder and nothing else."""
import json
import shutil
import subprocess
import unittest

from scratch import CopiedRepository, environment, whitelist


class Npm(CopiedRepository):
    def packed(self):
        quiet = environment(npm_config_cache=str(self.outside / "cache"), npm_config_update_notifier="false")
        done = subprocess.run([shutil.which("npm"), "pack", "--dry-run", "--json", "--offline", "--ignore-scripts"],
                              cwd=self.folder, capture_output=True, text=True, check=False, env=quiet)
        self.assertEqual(done.returncode, 0, done.stderr)
        return sorted(entry["path"] for entry in json.loads(done.stdout)[0]["files"])

    def test_packs_the_same_files(self):
        self.assertEqual(self.packed(), whitelist.shipped(self.folder).paths)

    def test_packs_the_same_of_what_may_lie_about(self):
        for path in ("Editor/Made/Made.cs", "Shaders/Made.shader", "Samples~/Made/.hidden", "tools/made.txt", "made.md",
                     "Documentation~/results/x/results.json", "Documentation~/results.json", "Documentation~/README",
                     "Runtime/.Made.cs.swp", "Runtime/Made.orig", "Runtime/.DS_Store", "Runtime/._Made",
                     "Runtime/CVS/Made", "Readme.txt"):
            self.write(path, "")
        self.assertEqual(self.packed(), whitelist.shipped(self.folder).paths)


if __name__ == "__main__":
    unittest.main()
