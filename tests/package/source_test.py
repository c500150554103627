"""Runs scripts/package --check on the repository, and breaks what only the repository can break."""
import json
import subprocess
import sys
import unittest

from scratch import ROOT, CopiedRepository

MANIFEST = "package.json"


class ThisRepository(unittest.TestCase):
    def test_it_keeps_every_rule(self):
        """The check runs with the real files of other packages, where PENUMBRA_URP_PACKAGES says where they are."""
        done = subprocess.run([sys.executable, str(ROOT / "scripts" / "package"), "--check"], capture_output=True,
                              text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^com\.penumbra\.shadows: \d+ files keep every rule\n$")


class Source(CopiedRepository):
    def refusals(self, *words, **more):
        """The messages of the check, without its last line."""
        *lines, last = self.assert_run(1, "--check", *words, **more).stderr.splitlines()
        count = f"{len(lines)} problem{'s' if len(lines) > 1 else ''}"
        self.assertEqual(last, f"scripts/package: {count}; nothing is packed")
        return lines

    def change_files(self, *without, add=()):
        files = json.loads(self.text(MANIFEST))["files"]
        self.change_manifest(files=[entry for entry in files if entry not in without] + list(add))

    def test_the_copy_keeps_every_rule(self):
        self.assertEqual(self.assert_run(0, "--check").stderr, "")

    def test_new_folders_ship_by_themselves(self):
        before = self.assert_run(0, "--check").stdout
        self.add("Editor/Made/Made.asmdef", '{"name": "Made.Editor", "includePlatforms": ["Editor"]}')
        self.add("Shaders/Made/Made.hlsl", "")
        self.add_sample("Made", "Made.hlsl", "")
        self.assertNotEqual(self.assert_run(0, "--check").stdout, before)

    def test_what_the_list_leaves_out(self):
        self.change_files("ShaderLibrary/", add=["ShaderLibrary/Core/"])
        self.assertIn(f"{MANIFEST}: 'files' leaves out ShaderLibrary/Shadows.hlsl: add \"ShaderLibrary/\"", self.refusals())
        self.change_files("ShaderLibrary.meta", add=["ShaderLibrary/"])
        self.assertEqual(self.refusals(), [f"{MANIFEST}: 'files' leaves out ShaderLibrary.meta: add \"ShaderLibrary.meta\"",
                                           "ShaderLibrary: has no ShaderLibrary.meta in the package: "
                                           "run scripts/package --metas"])

    def test_pages_are_not_left_out(self):
        self.write("Documentation~/results/made.md", "")
        self.change_files(add=["!Documentation~/results/*.md"])
        self.assertEqual(self.refusals(), [f"{MANIFEST}: 'files' leaves out Documentation~/results/made.md: "
                                           "add \"Documentation~/\""])

    def test_the_studys_figures_may_be(self):
        self.write("Documentation~/results/made/results.json", "{}")
        self.assert_run(0, "--check")

    def test_pictures_may_be_where_no_page_shows_them(self):
        self.write("Documentation~/results/made/overview.png", "")
        self.assert_run(0, "--check")
        self.write("Documentation~/made.md", "![a](results/made/overview.png)\n")
        self.assertEqual(self.refusals(), ["Documentation~/made.md:1:6: results/made/overview.png is not in the package: "
                                           "correct the link, or name the file in 'files' of package.json"])

    def test_what_is_none_of_the_packages(self):
        self.write("tools/made/made.txt", "")
        self.change_files(add=["tools/", "CMakeLists.txt", "scripts/package"])
        self.assertEqual([line for line in self.refusals() if line.startswith(MANIFEST)],
                         [f"{MANIFEST}: 'files' ships {path}, which is not part of the package: remove it"
                          for path in ("CMakeLists.txt", "scripts/package", "tools/made/made.txt")])

    def test_a_list_in_no_known_form(self):
        for entry in ("/Runtime", "../other", "Runtime/{a,b}", "**/a.md", "", 5):
            self.change_files(add=[entry])
            self.assert_refused(2, f"scripts/package: package.json: the entry {json.dumps(entry)} of 'files' has a form "
                                "that scripts/package does not read: write 'file', 'folder/', '*', '**/' or '!' before one of these",
                                "--check")
            self.change_files(entry)

    def test_no_list(self):
        text = ("scripts/package: package.json: has no list 'files' of what ships, and without one npm packs the whole "
                "folder: write one")
        for value in (None, "Runtime/"):
            self.change_manifest(files=value)
            self.assert_refused(2, text, "--check")
        self.write(MANIFEST, "[]")
        self.assert_refused(2, text, "--check")

    def test_no_manifest_that_can_be_read(self):
        self.write(MANIFEST, '{\n  "files": ]')
        self.assert_refused(2, "scripts/package: package.json:2:12: is not JSON: Expecting value", "--check")
        self.write(MANIFEST, "[" * 100000)
        self.assertRegex(self.assert_run(2, "--check").stderr, "^scripts/package: package.json: is not JSON that can be read: ")
        (self.folder / MANIFEST).unlink()
        self.assert_refused(2, "scripts/package: package.json: cannot be read: No such file or directory", "--check")

    def test_text_in_another_encoding(self):
        (self.folder / "ShaderLibrary/Shadows.hlsl").write_bytes(b"// caf\xe9\n")
        self.assert_refused(2, "scripts/package: ShaderLibrary/Shadows.hlsl: is not UTF-8 at byte 6: save it as UTF-8", "--check")

    def test_a_file_that_cannot_be_read(self):
        (self.folder / "ShaderLibrary/Made.hlsl").symlink_to("nothing")
        self.assert_refused(2, "scripts/package: ShaderLibrary/Made.hlsl: cannot be read: No such file or directory", "--check")

    def test_the_version_of_the_tools(self):
        version = json.loads(self.text(MANIFEST))["version"]
        place = self.place("CMakeLists.txt", f"VERSION {version}", len("VERSION "))
        self.replace("CMakeLists.txt", f"VERSION {version}", "VERSION 99.0.1")
        self.assertEqual(self.refusals(), [f"{place}: the project's version is 99.0.1, package.json's is {version}: "
                                           "make them one"])
        self.write("CMakeLists.txt", "")
        self.assertEqual(self.refusals(), [f"CMakeLists.txt: has no project(... VERSION {version}): add it"])
        (self.folder / "CMakeLists.txt").unlink()
        self.assertEqual(self.refusals(), ["CMakeLists.txt: cannot be read: No such file or directory"])

    def test_a_version_that_is_missing_is_told_once(self):
        self.change_manifest(version=None)
        self.assertEqual(self.refusals(), [f"{MANIFEST}:1:1: 'version' is not a semantic version: write one like \"1.2.3\" or "
                                           "\"1.2.3-pre.1\""])

    def test_a_pre_release_has_the_version_of_its_release(self):
        version = json.loads(self.text(MANIFEST))["version"]
        self.change_manifest(version=f"{version}-pre.1")
        self.write("CHANGELOG.md", f"## [{version}-pre.1] - Unreleased\n")
        self.assert_run(0, "--check")


class RootsOfPackages(CopiedRepository):
    def fill(self):
        super().fill()
        self.root = self.outside / "packages" / "com.unity.render-pipelines.universal"
        self.root.mkdir(parents=True)

    def test_from_the_command_line(self):
        done = self.assert_run(1, "--check", "--package-root", f"{self.root.name}={self.root}")
        self.assertIn(f"there is no ShaderLibrary/Core.hlsl in {self.root.name}: correct the path", done.stderr)

    def test_from_the_environment(self):
        done = self.assert_run(1, "--check", PENUMBRA_URP_PACKAGES=str(self.root.parent))
        self.assertIn(f"there is no ShaderLibrary/Core.hlsl in {self.root.name}: correct the path", done.stderr)

    def test_folders_that_are_not_there(self):
        for given in ("a", "a=", "=b", "a=nothing"):
            self.assert_refused(2, f"scripts/package: --package-root {given}: is not NAME=DIR with a folder that exists",
                                "--check", "--package-root", given)
        self.assert_refused(2, "scripts/package: PENUMBRA_URP_PACKAGES: nothing is not a folder: "
                            "name one that holds packages, or unset it", "--check", PENUMBRA_URP_PACKAGES="nothing")


if __name__ == "__main__":
    unittest.main()
