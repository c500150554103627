"""Runs scripts/pictures over the pages as they are, and over made-up ones; the program is a stand-in that says what it
is asked for."""
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SCRIPT = Path("scripts") / "pictures"
PACKAGES = "PENUMBRA_URP_PACKAGES"
LARGEST = 1_000_000  # bytes
WIDEST = 1600  # pixels


def width(file):
    """From the header of a PNG, or the frame of a JPEG, which follows segments that each begin with their length."""
    data = file.read_bytes()
    if data.startswith(b"\x89PNG"):
        return int.from_bytes(data[16:20], "big")
    at = 2
    while data[at + 1] not in (0xC0, 0xC1, 0xC2):
        at += 2 + int.from_bytes(data[at + 2:at + 4], "big")
    return int.from_bytes(data[at + 7:at + 9], "big")


class Pages(unittest.TestCase):
    def test_every_picture_is_drawn_by_the_page_that_shows_it(self):
        listed = subprocess.run([ROOT / SCRIPT, "--list"], check=True, capture_output=True, text=True).stdout
        drawn = dict(line.split(" ") for line in listed.splitlines())
        there = {file.stem for file in (ROOT / "Documentation~" / "images").iterdir()}
        self.assertEqual(set(drawn), there)
        for name, page in drawn.items():
            self.assertRegex((ROOT / page).read_text(), rf"\]\((\.\./Documentation~/)?images/{name}\.(png|jpg)\)")

    def test_a_picture_of_the_readme_is_the_one_that_its_command_draws(self):
        readme = (ROOT / "README.md").read_text()
        shown = re.findall(r"\]\(Documentation~/images/([a-z-]+)\.(?:png|jpg)\)", readme)
        self.assertEqual(re.findall("`PENUMBRA_URP_PACKAGES=DIR scripts/pictures ([a-z-]+)`", readme), shown)
        subprocess.run([ROOT / SCRIPT, "--list", *shown], check=True, capture_output=True)

    def test_no_picture_is_large(self):
        for file in (ROOT / "Documentation~" / "images").iterdir():
            self.assertLess(file.stat().st_size, LARGEST, file.name)
            self.assertLessEqual(width(file), WIDEST, file.name)


class Script(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        for folder in ("scripts", "Documentation~"):
            (self.root / folder).mkdir()
        shutil.copy(ROOT / SCRIPT, self.root / SCRIPT)
        self.program = self.root / "program"
        self.program.write_text('#!/bin/sh\nprintf "<%s>" "$@"\necho\n[ "$2" != --broken ] || exit 7\n')
        self.program.chmod(0o755)
        (self.root / "bin").mkdir()
        for tool in ("jpegtran", "optipng"):
            (self.root / "bin" / tool).write_text(f'#!/bin/sh\necho {tool} "$@" >>"{self.root}/shrunk"\n')
            (self.root / "bin" / tool).chmod(0o755)

    def shrunk(self):
        return (self.root / "shrunk").read_text()

    def page(self, *commands, name="page.md"):
        text = "".join(f"Text.\n\n```sh\n{command}\n```\n" for command in commands)
        (self.root / "Documentation~" / name).write_text(text)

    def run_script(self, *arguments, packages=None):
        environment = {key: value for key, value in os.environ.items() if key != PACKAGES}
        environment["PATH"] = f"{self.root / 'bin'}:{environment['PATH']}"
        if packages:
            environment[PACKAGES] = packages
        return subprocess.run([self.root / SCRIPT, "--program", self.program, *arguments], env=environment,
                              capture_output=True, text=True)

    def test_commands_are_run_as_they_stand(self):
        self.page("penumbra render --adapter 'a=b;C' \\\n  --sheet Documentation~/images/one.png",
                  "penumbra render --sheet elsewhere.png", "penumbra measure --output report", "other --sheet x.png")
        result = self.run_script()
        self.assertEqual(result.stdout, "<render><--adapter><a=b;C><--sheet><Documentation~/images/one.png><--max-width><1600>\n")
        self.assertEqual(result.returncode, 0)

    def test_names_choose(self):
        self.page(*(f"penumbra render --sheet Documentation~/images/{name}.png" for name in ("one", "two")))
        self.assertEqual(self.run_script("two").stdout, "<render><--sheet><Documentation~/images/two.png><--max-width><1600>\n")
        self.assertEqual(self.shrunk(), "optipng -quiet -o2 Documentation~/images/two.png\n")
        unknown = self.run_script("three")
        self.assertEqual(unknown.returncode, 2)
        self.assertIn("no page draws a picture Documentation~/images/three; there are: one two", unknown.stderr)

    def test_a_picture_is_a_png_or_a_jpeg(self):
        self.page("penumbra render --sheet Documentation~/images/one.jpg")
        self.assertEqual(self.run_script().stdout, "<render><--sheet><Documentation~/images/one.jpg><--max-width><1600>\n")
        file = "Documentation~/images/one.jpg"
        self.assertEqual(self.shrunk(), f"jpegtran -copy none -optimize -progressive -outfile {file} {file}\n")

    def test_packages_stand_for_dir(self):
        self.page("penumbra render --package-root com.unity.a-b=DIR --sheet Documentation~/images/one.png")
        without = self.run_script()
        self.assertEqual((without.returncode, without.stdout), (0, ""))
        self.assertIn(f"one.png: stays as it is: {PACKAGES} names no folder", without.stderr)
        self.assertIn("<com.unity.a-b=/packages/com.unity.a-b>", self.run_script(packages="/packages").stdout)

    def test_a_failure_ends_it(self):
        self.page("penumbra render --broken --sheet Documentation~/images/one.png",
                  "penumbra render --sheet Documentation~/images/two.png")
        result = self.run_script()
        self.assertEqual(result.returncode, 7)
        self.assertNotIn("two.png", result.stdout)

    def test_commands_that_are_none(self):
        self.page("penumbra render --sheet Documentation~/images/one.gif")
        self.assertIn("Documentation~/page.md: Documentation~/images/one.gif ends in neither .png nor .jpg",
                      self.run_script().stderr)
        self.page("penumbra render --sheet Documentation~/images/one.png")
        self.page("penumbra render --sheet Documentation~/images/one.png", name="other.md")
        twice = self.run_script()
        self.assertEqual(twice.returncode, 2)
        self.assertIn("is drawn by a command of Documentation~/other.md, too", twice.stderr)


if __name__ == "__main__":
    unittest.main()
