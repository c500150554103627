"""The changelog's form and version, where the pages' links lead, and that the first page leads to all."""
import json
import re
import unittest
from pathlib import Path

from scratch import ROOT, CopiedRepository, UnpackedTarball, whitelist

PATH = "CHANGELOG.md"
PAGE = "Documentation~/made.md"
NOT_THERE = "is not in the package: correct the link, or name the file in 'files' of package.json"


class Changelog(UnpackedTarball):
    def fill(self):
        super().fill()
        self.version = json.loads(self.text("package.json"))["version"]

    def with_headings(self, *headings):
        self.write(PATH, "# Changelog\n" + "".join(f"\n## {heading}\n" for heading in headings))

    def test_forms_that_are_right(self):
        for headings in ((f"[{self.version}] - 2026-01-31",), (f"[{self.version}] - Unreleased",),
                         ("[Unreleased]", f"[{self.version}] - 2024-02-29", f"[{self.version}-pre.2] - 2024-01-01",
                          f"[{self.version}-pre.1] - 2023-01-01", f"[{self.version}-0] - 2022-01-01", "[0.0.1] - 2021-01-01")):
            self.with_headings(*headings)
            self.assert_problems()

    def test_headings_of_no_release(self):
        for heading in ("0.1.1", "[0.1.1]", "[0.1.1] - 31.1.2026", "[0.1.1] - 2026-02-30", "[0.1.1] - 20260131",
                        "[1.1] - 2026-01-31", "[Unreleased] - 2026-01-31", "Unreleased", "[0.1.1] 2026-01-31"):
            self.with_headings(heading, f"[{self.version}] - 2026-01-31")
            self.assert_problems(f"{PATH}:3:1: '## {heading}' heads no release: write '## [1.2.3] - 2026-01-31', "
                                 "'## [1.2.3] - Unreleased' or '## [Unreleased]'")

    def test_the_order_of_releases(self):
        for wrong in (self.version, "99.0.0", f"{self.version}-pre.1"):
            first, second = (self.version, wrong) if "-pre" not in wrong else (wrong, self.version)
            self.change_manifest(version=first)
            self.with_headings(f"[{first}] - 2026-01-31", f"[{second}] - 2026-01-30")
            self.assert_problems(f"{PATH}:5:1: {second} stands below {first}: the newest release comes first, each once")

    def test_what_is_unreleased_stands_on_top(self):
        self.with_headings(f"[{self.version}] - 2026-01-31", "[Unreleased]")
        self.assert_problems(f"{PATH}:5:1: '## [Unreleased]' stands below a release: move it to the top")

    def test_another_version_than_the_packages(self):
        self.with_headings("[Unreleased]", "[99.0.0] - 2026-01-31")
        self.assert_problems(f"{PATH}:5:1: the newest version is 99.0.0, package.json's is {self.version}: "
                             "make them one")

    def test_no_version(self):
        self.with_headings("[Unreleased]")
        self.assert_problems(f"{PATH}:1:1: the newest version is missing, package.json's is {self.version}: "
                             "make them one")

    def test_kinds_of_changes(self):
        self.write(PATH, f"# Changelog\n\n## [{self.version}] - Unreleased\n\n### Added\n\n### New things\n")
        self.assert_problems(f"{PATH}:7:1: '### New things' is not a kind of change: write one of Added, Changed, Deprecated, "
                             "Removed, Fixed, Security")


class Links(UnpackedTarball):
    def test_links_that_lead_somewhere(self):
        self.write(PAGE, "[a](filters.md) [b](../README.md#requirements) ![c](results/presets/pareto-fetches.svg \"title\") [d](#here)\n"
                         "[e](https://example.com/nothing.md) [f](../ShaderLibrary) [g](<filters.md>) [h](mailto:a@example.com)\n")
        self.assert_problems()

    def test_one_that_leads_nowhere(self):
        for target in ("nothing.md", "../tools/cli/main.cpp", "results/overview.jpg", "README.md"):
            self.write(PAGE, f"# Made\n\nSee [this]({target}#part).\n")
            self.assert_problems(f"{PAGE}:3:12: {target}#part {NOT_THERE}")

    def test_code_has_no_links(self):
        self.write(PAGE, "`a[0](nothing)`\n\n```\nb[1](nothing)\n```\n\n[c](nothing.md)\n")
        self.assert_problems(f"{PAGE}:7:5: nothing.md {NOT_THERE}")


class Pictures(UnpackedTarball):
    TEXT = "no page of the package shows it: show it in one, or add \"!{}\" to 'files' of package.json"

    def test_one_that_no_page_shows(self):
        for name in ("Documentation~/images/made.png", "Documentation~/results/made/chart.svg",
                     "Documentation~/results/made/made.json", "Documentation~/made.JPG"):
            self.write(name, "")
            self.assert_problems(f"{name}: {self.TEXT.format(name)}")
            self.write(PAGE, f"![a]({name.removeprefix('Documentation~/')})\n")
            self.assert_problems()
            (self.folder / name).unlink()
            (self.folder / PAGE).unlink()

    def test_one_that_is_only_named(self):
        name = "Documentation~/images/made.png"
        self.write(name, "")
        self.write(PAGE, "```sh\npenumbra render --sheet Documentation~/images/made.png\n```\n`![a](images/made.png)`\n")
        self.assert_problems(f"{name}: {self.TEXT.format(name)}")


class Readme(UnpackedTarball):
    """The package's own page is for users who have installed it: Unity's Project window shows it for the package."""

    def test_is_not_the_repositorys(self):
        self.assertNotEqual((self.folder / "README.md").read_text(), (ROOT / "README.md").read_text())
        for word in ("scripts/demo", "scripts/test", "cmake", "build/release"):
            self.assertNotIn(word, self.text("README.md"))

    def test_leads_to_the_pages_of_its_readers(self):
        for page in ("installation", "presets", "renderer-feature", "other-shadows", "troubleshooting", "index"):
            self.assertIn(f"](Documentation~/{page}.md", self.text("README.md"), page)

    def test_a_link_that_leads_nowhere_is_told_at_its_source(self):
        root = CopiedRepository("run_script")
        root.setUp()
        self.addCleanup(root.doCleanups)
        source = whitelist.SOURCES["README.md"]
        root.write(source, "[a](tools/nothing.md)\n")
        self.assertIn(f"{source}:1:5: tools/nothing.md {NOT_THERE}\n", root.assert_run(1, "--check").stderr)


class Names(unittest.TestCase):
    """Each technique has one name, that of ShadowTechnique's list in the inspector. A test in C# compares the titles."""

    OTHERS = re.compile(r"PCSS HDRP|PCSS Poisson|[Cc]lassic PCSS|Angular PCSS|PCSS by angular diameter|HDRP match|"
                        r"[Tt]ent (?:PCF )?\d x \d|Tent PCF|HDRP's PCSS")

    def test_no_page_or_script_has_another(self):
        package = whitelist.shipped(ROOT)
        files = [ROOT / "README.md", *(ROOT / package.source(path) for path in package.ending(".md", ".cs", ".json"))]
        for file in files:
            for number, line in enumerate(file.read_text().splitlines(), 1):
                # HDRP's own shadow is not the technique that follows it.
                self.assertIsNone(self.OTHERS.search(line.replace("HDRP's own", "")), f"{file}:{number}: {line}")


class Looks(unittest.TestCase):
    """presets.md says of each look what the list says, and draws its picture with these values."""

    def test_stand_on_their_page(self):
        page = (ROOT / "Documentation~" / "presets.md").read_text()
        looks = json.loads((ROOT / "Shaders" / "PenumbraShadows.technique.json").read_text())["looks"]
        self.assertEqual(len(looks), 4)
        for look in looks:
            degrees, metres = f"{look['angularDiameterDegrees']:g}", f"{look['maxPenumbraMetres']:g}"
            self.assertIn(f"\n| {look['title']} | {degrees}° | {metres} m | {look['doc']} |\n", page)
            command = re.search(rf"^penumbra render (?:[^\n]*\\\n)*[^\n]*images/look-{look['name']}\.jpg$", page, re.MULTILINE)
            self.assertIsNotNone(command, look["name"])
            self.assertIn(f"--light {degrees} ", command[0])
            capped = re.search(r"--set maxPenumbraMetres=(\S+)", command[0])
            self.assertEqual(capped[1] if capped else "100", metres)


class Index(unittest.TestCase):
    def test_every_page_has_its_line(self):
        """Unity's Package Manager opens index.md, and nothing shows its users a list of the others."""
        folder = Path(__file__).resolve().parent.parent.parent / "Documentation~"
        lines = re.findall(r"^- \[[^]]+\]\(([^)#]+\.md)\): .", (folder / "index.md").read_text(), re.MULTILINE)
        pages = {page.name for page in folder.glob("*.md")} - {"index.md"}
        self.assertEqual(sorted(lines), sorted(pages))


if __name__ == "__main__":
    unittest.main()
