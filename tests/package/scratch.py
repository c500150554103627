"""Copies of the package that a test may break, and of the repository that it is made from."""
import functools
import io
import json
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "scripts"))
from penumbra_package import metas, rules, tarball, whitelist  # noqa: E402
from penumbra_package.package import Package, unpacked  # noqa: E402

# A program in a scratch folder must not take these from the caller: other packages, and a hook's or a user's git.
OUTSIDE = ("PENUMBRA_URP_PACKAGES", "GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX")
SOMEBODY = {f"GIT_{role}_{part}": value for role in ("AUTHOR", "COMMITTER") for part, value in
            (("NAME", "Somebody"), ("EMAIL", "somebody@example.com"), ("DATE", "2026-01-02T03:04:05+01:00"))}


def environment(**more):
    kept = {name: value for name, value in os.environ.items() if name not in OUTSIDE}
    return {**kept, "GIT_CONFIG_GLOBAL": "", "GIT_CONFIG_NOSYSTEM": "1", **SOMEBODY, **more}


class Folder(unittest.TestCase):
    """A temporary folder for each test."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.outside = Path(temporary.name).resolve()
        self.folder = self.outside / "content"
        self.folder.mkdir()
        self.fill()

    def fill(self):
        pass

    def text(self, path):
        return (self.folder / path).read_text()

    def write(self, path, text):
        """Writes the file, without the .meta that it may need."""
        (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / path).write_text(text)

    def add(self, path, text):
        """Writes the file, with every .meta that it needs."""
        self.write(path, text)
        texts, problems = metas.missing_metas(Package(self.folder, [path]))
        self.assertEqual(problems, [])
        for meta, content in texts.items():
            self.write(meta, content)

    def replace(self, path, old, new):
        text = self.text(path)
        self.assertEqual(text.count(old), 1, f"{path} has {old!r} not once")
        self.write(path, text.replace(old, new))

    def place(self, path, text, into=0):
        """The place at which the text, which is in the file once, begins, with `into` characters of it passed over."""
        whole = self.text(path)
        self.assertEqual(whole.count(text), 1, f"{path} has {text!r} not once")
        before = whole[:whole.index(text) + into]
        return f"{path}:{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"

    def change_manifest(self, **values):
        """Sets keys of package.json, or takes away those whose value is None."""
        manifest = json.loads(self.text("package.json"))
        manifest.update(values)
        kept = {key: value for key, value in manifest.items() if value is not None}
        self.write("package.json", json.dumps(kept, indent=2))

    def add_sample(self, name, file, text):
        """Adds a sample of one file with its .meta, and its entry in package.json."""
        self.add(f"Samples~/{name}/{file}", text)
        samples = json.loads(self.text("package.json")).get("samples", [])
        entry = {"displayName": name, "description": f"{name}, made up.", "path": f"Samples~/{name}"}
        self.change_manifest(samples=[*samples, entry])


@functools.cache
def packed():
    return tarball.tarball(whitelist.shipped(ROOT))


class UnpackedTarball(Folder):
    """The package as a user has it: the tarball of this work tree, unpacked. `before` is what the rules say of it."""

    before = None

    def fill(self):
        with tarfile.open(fileobj=io.BytesIO(packed())) as archive:
            for entry in archive:
                self.assertTrue(entry.isfile() and entry.name.startswith("package/"), entry.name)
                path = self.folder / entry.name.removeprefix("package/")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(archive.extractfile(entry).read())

        if UnpackedTarball.before is None:
            UnpackedTarball.before = [str(problem) for problem in rules.problems(unpacked(self.folder), {})]

    def problems(self, **roots):
        """The problems that the rules find here and not in the tarball itself, which a test in files_test.py is about."""
        found = [str(problem) for problem in rules.problems(unpacked(self.folder), roots)]
        return [problem for problem in found if problem not in self.before]

    def assert_problems(self, *expected, **roots):
        self.assertEqual(self.problems(**roots), list(expected))


class CopiedRepository(Folder):
    """A copy of the files of the repository that scripts/package reads, with the script itself."""

    def fill(self):
        shipped = whitelist.shipped(ROOT).paths
        for path in (*shipped, *whitelist.SOURCES.values(), "CMakeLists.txt", "scripts/package"):
            (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / path, self.folder / path)
        shutil.copytree(ROOT / "scripts" / "penumbra_package", self.folder / "scripts" / "penumbra_package",
                        ignore=shutil.ignore_patterns("__pycache__"))

    def run_script(self, *words, **more):
        return subprocess.run([sys.executable, str(self.folder / "scripts" / "package"), *map(str, words)], text=True,
                              capture_output=True, check=False, cwd=self.outside, env=environment(**more))

    def assert_run(self, code, *words, **more):
        done = self.run_script(*words, **more)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def assert_refused(self, code, message, *words, **more):
        self.assertEqual(self.assert_run(code, *words, **more).stderr, message + "\n")

    def sources(self):
        """The files of this copy that the package is made of."""
        package = whitelist.shipped(self.folder)
        return [package.source(path) for path in package.paths]

    def shipped(self, path):
        """The bytes that the package has at the path."""
        return (self.folder / whitelist.SOURCES.get(path, path)).read_bytes()

    def contents(self):
        """Every file's bytes by its path."""
        return {path: (self.folder / path).read_bytes() for path in unpacked(self.folder).paths}
