"""What the package's pages say about the names of techniques, the looks and the readers of the package's README."""
import json
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


class Readme(unittest.TestCase):
    def test_is_for_users_of_unity(self):
        """Unity's Project window shows this page when the package is selected."""
        text = (ROOT / "scripts" / "package-readme.md").read_text()
        for word in ("scripts/demo", "scripts/test", "cmake", "build/release"):
            self.assertNotIn(word, text)
        for page in ("installation", "presets", "renderer-feature", "other-shadows", "troubleshooting", "index"):
            self.assertIn(f"](Documentation~/{page}.md", text)


class Names(unittest.TestCase):
    """Each technique has one name, that of ShadowTechnique's list in the inspector. A test in C# compares the titles."""

    OTHERS = re.compile(r"PCSS HDRP|PCSS Poisson|[Cc]lassic PCSS|Angular PCSS|PCSS by angular diameter|HDRP match|"
                        r"[Tt]ent (?:PCF )?\d x \d|Tent PCF|HDRP's PCSS")

    def test_no_page_or_script_has_another(self):
        folders = ("Documentation~", "Editor", "Runtime", "Samples~", "ShaderLibrary", "Shaders")
        files = [path for folder in folders for path in (ROOT / folder).rglob("*.*")
                 if path.suffix in (".md", ".cs", ".json")]
        files += [ROOT / "README.md", ROOT / "CHANGELOG.md", ROOT / "scripts" / "package-readme.md"]
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
            picture = rf"images/look-{look['name']}\.jpg"
            command = re.search(rf"^penumbra render (?:[^\n]*\\\n)*[^\n]*{picture}$", page, re.MULTILINE)
            self.assertIsNotNone(command, look["name"])
            self.assertIn(f"--light {degrees} ", command[0])
            capped = re.search(r"--set maxPenumbraMetres=(\S+)", command[0])
            self.assertEqual(capped[1] if capped else "100", metres)


if __name__ == "__main__":
    unittest.main()
