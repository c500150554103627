"""scripts/package on a small package, and every rule of scripts/package_check.py broken once."""
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "scripts"))
from package_check import problems  # noqa: E402

URP = "com.unity.render-pipelines.universal"
FILES = {
    "package.json": json.dumps({
        "name": "com.penumbra.shadows", "version": "1.2.3", "unity": "2022.3", "displayName": "Penumbra",
        "description": "Made up.", "dependencies": {URP: "14.0.0"},
        "samples": [{"displayName": "Made", "description": "Made up.", "path": "Samples~/Made"}],
        "files": ["*.md", "*.meta", "Runtime/", "Editor/", "Samples~/", "Documentation~/",
                  "!Documentation~/left-out.svg"]}),
    "README.md": "For who builds the tools.\n",
    "LICENSE.md": "",
    "CHANGELOG.md": "## [Unreleased]\n\n## [1.2.3] - 2026-01-31\n\n## [1.2.2] - 2026-01-30\n",
    "Third Party Notices.md": "`Runtime/Taken.hlsl`\n",
    "Documentation~/index.md": "[page](page%20two.md#head) `[a](none.md)` [a](https://example.com)\n",
    "Documentation~/page two.md": "[head](#head)\n\n![](shown.svg)\n",
    "Documentation~/shown.svg": "",
    "Documentation~/left-out.svg": "",
    "Runtime/Made.asmdef": '{"name": "Made", "references": ["Unity.RenderPipelines.Core.Runtime"], '
                           '"versionDefines": [{"expression": "[14.0,17.0)"}]}',
    "Runtime/Made.cs": "",
    "Runtime/Taken.hlsl": "// Source: google/filament\n#ifndef TAKEN\n",
    "Runtime/Made.shader": '// #include "None.hlsl"\n/*\n#include "None.hlsl"\n*/ # include "./Taken.hlsl" // why\n'
                           f'#include_with_pragmas "Packages/{URP}/There.hlsl"\n',
    "Editor/Made.Editor.asmdef": '{"name": "Made.Editor", "references": ["Made"], "includePlatforms": ["Editor"]}',
    "Samples~/Made/Made.shader": '#include "Packages/com.penumbra.shadows/Runtime/Taken.hlsl"\n',
    "scripts/package-readme.md": "[For users](Documentation~/index.md)\n",
}
GONE = None


def guid(path):
    return hashlib.md5(f"com.penumbra.shadows/{path}".encode()).hexdigest()


MANIFEST, ASSEMBLY = "package.json", "Runtime/Made.asmdef"
SHADER, SAMPLE = "Runtime/Made.shader", "Samples~/Made/Made.shader"
NO_META = "has no .meta: run scripts/package --metas"
RULES = [  # The file, the text in it that is replaced (all of it if empty), its replacement, and the problem.
    ("Runtime/aux.hlsl", "", "", "Runtime/aux.hlsl: Windows cannot hold this name, or it is not ASCII"),
    ("Runtime/Café.cs", "", "", "Runtime/Café.cs: Windows cannot hold this name, or it is not ASCII"),
    ("Runtime/taken.hlsl", "", "", "Runtime/taken.hlsl: differs only in case from Runtime/Taken.hlsl"),
    ("Runtime/Made.cpp", "", "", "Runtime/Made.cpp: Unity compiles such files into players as native code"),
    ("Runtime.meta", "", GONE, f"Runtime: {NO_META}"),
    (f"{SAMPLE}.meta", "", GONE, f"{SAMPLE}: {NO_META}"),
    ("Runtime/Made.cs", "", GONE, "Runtime/Made.cs.meta: belongs to nothing that Unity imports"),
    ("Samples~/Made.meta", "", "", "Samples~/Made.meta: belongs to nothing that Unity imports"),
    ("Runtime.meta", "guid: ", "guid: -", "Runtime.meta: has no guid of 32 digits"),
    ("Runtime.meta", guid("Runtime"), guid("Editor"), "Runtime.meta: has the guid of Editor.meta"),
    ("LICENSE.md", "", GONE, "LICENSE.md: is missing"),
    (MANIFEST, "penumbra.shadows", "penumbra", "package.json: 'name' is not com.penumbra.shadows"),
    (MANIFEST, "1.2.3", "1.2.2", "package.json: 'version' is not that of the changelog's newest release"),
    (MANIFEST, "1.2.3", "v1.2.3", "package.json: 'v1.2.3' is not a semantic version"),
    (MANIFEST, "2022.3", "2022", "package.json: 'unity' is not a version like 2022.3"),
    (MANIFEST, '"Penumbra"', '""', "package.json: 'displayName' or 'description' is empty"),
    (MANIFEST, URP, "com.example", f"package.json: 'dependencies' is without {URP}"),
    (MANIFEST, "14.0.0", "14.0", "package.json: '14.0' is not a semantic version"),
    (MANIFEST, "Samples~/Made", "Samples/Made",
     "package.json: the samples list and the folders differ in Samples~/Made"),
    ("Editor/Made.asmdef", "", '{"name": "Made"}', f"Editor/Made.asmdef: has the name of {ASSEMBLY}"),
    ("Editor/Made.Editor.asmdef", "includePlatforms", "excludePlatforms",
     "Editor/Made.Editor.asmdef: is in a folder Editor, but not for the platform Editor alone"),
    (ASSEMBLY, "Unity.RenderPipelines.Core.Runtime", "None", f"{ASSEMBLY}: there is no assembly None"),
    (ASSEMBLY, "Unity.RenderPipelines.Core.Runtime", "Made.Editor", f"{ASSEMBLY}: players do not have Made.Editor"),
    (ASSEMBLY, "[14.0,17.0)", ">=14", f"{ASSEMBLY}: '>=14' is no range of versions like [14.0,17.0)"),
    ("Other/Made.cs", "", "", "Other/Made.cs: belongs to no assembly definition, so Unity does not compile it"),
    (SHADER, "", '\n#include <Taken.hlsl>', f"{SHADER}:2: <Taken.hlsl> is not a path in quotes"),
    (SHADER, "", '/*\n*/#include "None.hlsl"', f"{SHADER}:2: there is no Runtime/None.hlsl in the package"),
    (SHADER, "", '#include "taken.hlsl"', f"{SHADER}:1: there is no Runtime/taken.hlsl in the package"),
    (SHADER, f"Packages/{URP}", "Packages/com.example", f"{SHADER}:5: com.example is not a dependency of the package"),
    (SHADER, "There.hlsl", "None.hlsl", f"{SHADER}:5: there is no None.hlsl in {URP}"),
    (SAMPLE, "Runtime/Taken", "Taken", f"{SAMPLE}:1: there is no Taken.hlsl in the package"),
    (SAMPLE, "Packages/com.penumbra.shadows", "../..",
     f'{SAMPLE}:1: "../../Runtime/Taken.hlsl" leads out of the sample, which is copied into projects'),
    ("Documentation~/page two.md", "shown.svg", "left-out.svg",
     "Documentation~/page two.md:3: left-out.svg is not in the package"),
    ("Documentation~/page two.md", "shown.svg", "#head", "Documentation~/shown.svg: no page leads to it: "
     "link it, or leave it out by a '!' in 'files' of package.json"),
    ("Third Party Notices.md", "Taken", "None", "Third Party Notices.md: there is no Runtime/None.hlsl"),
    ("Third Party Notices.md", "Taken", "None",
     "Third Party Notices.md: Runtime/Taken.hlsl is transcribed and not named")]


class Repository(unittest.TestCase):
    """A small repository of a package and the scripts that pack it."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name) / "repository"
        self.output = Path(scratch.name) / "output"
        (Path(scratch.name) / URP).mkdir()
        (Path(scratch.name) / URP / "There.hlsl").touch()
        others = mock.patch.dict(os.environ, PENUMBRA_URP_PACKAGES=scratch.name)
        others.start()
        self.addCleanup(others.stop)
        for path, text in FILES.items():
            self.write(path, text)
        for name in ("package", "package_check.py"):
            shutil.copy(ROOT / "scripts" / name, self.root / "scripts")
        self.metas = self.run_script("--metas").split("\n")[:-1]

    def write(self, path, text, root=None):
        path = (root or self.root) / path
        path.parent.mkdir(parents=True, exist_ok=True)
        if text is GONE:
            path.unlink()
        else:
            path.write_text(text, encoding="utf-8")

    def run_script(self, *words, code=0, **environment):
        command = [sys.executable, str(self.root / "scripts/package"), f"--output={self.output}", *words]
        done = subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, **environment})
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr if code else done.stdout


class Rules(Repository):
    def test_each_is_seen_broken(self):
        self.run_script("--upm")
        folder = self.output / "upm"
        for path, old, new, problem in RULES:
            with self.subTest(problem):
                whole = (folder / path).read_text(encoding="utf-8") if (folder / path).exists() else GONE
                if old:
                    self.assertIn(old, whole)
                self.write(path, whole.replace(old, new, 1) if old else new, folder)
                self.assertIn(problem, problems(folder))
                self.write(path, whole, folder)
                shutil.rmtree(folder / "Other", ignore_errors=True)
                self.assertEqual(problems(folder), [])
        self.write(ASSEMBLY, "{", folder)
        with self.assertRaisesRegex(SystemExit, f"^{ASSEMBLY}: is not JSON: "):
            problems(folder)


class Script(Repository):
    def git(self, *words):
        identity = ("-c", "user.name=Somebody", "-c", "user.email=somebody@example.com")
        return subprocess.run(["git", *identity, *words], cwd=self.root, check=True, capture_output=True,
                              text=True).stdout.strip()

    def commit(self):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message=Made")
        return self.git("rev-parse", "HEAD")

    def shipped(self):
        outside = ("scripts/package-readme.md", "Documentation~/left-out.svg")
        return {path for path in (*FILES, *self.metas) if path not in outside}

    def test_metas(self):
        imported = [path for path in FILES if not path.startswith(("Documentation~/", "scripts/"))]
        self.assertEqual(self.metas, sorted(f"{path}.meta" for path in (*imported, "Runtime", "Editor")))
        before = (self.root / "Runtime.meta").read_text()
        self.write("Runtime.meta", GONE)
        self.assertIn(f"Runtime: {NO_META}\nscripts/package: nothing is packed", self.run_script("--upm", code=1))
        self.assertFalse(self.output.exists())
        self.assertEqual(self.run_script("--metas"), "Runtime.meta\n")
        self.assertEqual((self.root / "Runtime.meta").read_text(), before)

    def test_the_tarball_has_the_files_and_the_readme_of_the_package(self):
        self.run_script()
        with tarfile.open(self.output / "com.penumbra.shadows-1.2.3.tgz") as archive:
            self.assertEqual({member.name for member in archive}, {f"package/{path}" for path in self.shipped()})
            readme = archive.extractfile("package/README.md").read().decode()
        self.assertEqual(readme, FILES["scripts/package-readme.md"])

    def test_the_branch_has_the_files_alone(self):
        self.git("init", "--quiet", "--initial-branch=main")
        head = self.commit()
        self.run_script("--branch", "upm")
        self.assertEqual(set(self.git("ls-tree", "-r", "--name-only", "upm").split("\n")), self.shipped())
        self.assertEqual(self.git("diff", "--name-only", "--diff-filter=d", "main", "upm"), "README.md")
        self.assertEqual(self.git("log", "-1", "--format=%B", "upm"),
                         f"com.penumbra.shadows 1.2.3\n\nThe package's files of commit {head}.")
        self.assertEqual((self.git("rev-parse", "HEAD"), self.git("status", "--porcelain")), (head, ""))
        first = self.git("rev-parse", "upm")
        self.assertIn("has these files already", self.run_script("--branch", "upm"))
        self.write("LICENSE.md", "Free.\n")
        self.assertIn("commit these first", self.run_script("--branch", "upm", code=1))
        self.commit()
        self.run_script("--branch", "upm")
        self.assertEqual(self.git("rev-parse", "upm^"), first)
        self.assertIn("exists and contains no package", self.run_script("--branch", "main", code=2))

    def test_a_folder_of_somebody_else_stays(self):
        (self.output / "upm").mkdir(parents=True)
        self.assertIn("exists and is not a package", self.run_script("--upm", code=2))

    def test_without_npm(self):
        self.assertIn("npm is not installed", self.run_script(code=3, PATH=""))


class Penumbra(unittest.TestCase):
    def test_has_no_problems(self):
        done = subprocess.run([sys.executable, ROOT / "scripts/package", "--check"], capture_output=True, text=True,
                              check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
