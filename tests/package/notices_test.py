"""The notices of third parties in the tarball name every file that says it comes from one, and carry the licences' texts."""
import re
import unittest

from scratch import UnpackedTarball

NOTICES = "Third Party Notices.md"
WORKS = re.compile(r"google/filament|godotengine/godot|Google's Filament|FilamentTaps\.hlsl")


class Notices(UnpackedTarball):
    def named(self):
        text = self.text(NOTICES)
        return set(re.findall(r"`((?:ShaderLibrary|Runtime)/[^`]+)`", text))

    def test_the_files_named_are_there(self):
        self.assertEqual([name for name in sorted(self.named()) if not (self.folder / name).is_file()], [])

    def test_every_file_from_a_third_party_is_named(self):
        said = {str(path.relative_to(self.folder)) for path in (self.folder / "ShaderLibrary").rglob("*.hlsl")
                if WORKS.search(path.read_text().split("#ifndef")[0])}
        self.assertGreaterEqual(len(said), 4)
        self.assertLessEqual(said, self.named())

    def test_the_licences_are_whole(self):
        text = " ".join(self.text(NOTICES).split())
        for part in ("Copyright The Android Open Source Project", "Apache License Version 2.0, January 2004",
                     "9. Accepting Warranty or Additional Liability.", "END OF TERMS AND CONDITIONS",
                     "Copyright (c) 2014-present Godot Engine contributors",
                     "The above copyright notice and this permission notice shall be included in all copies",
                     "OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE."):
            self.assertIn(part, text)


if __name__ == "__main__":
    unittest.main()
