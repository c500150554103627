"""The tarball holds the files that package.json names, and is the same bytes whoever makes it, whenever."""
import io
import os
import tarfile
import unittest

from scratch import ROOT, CopiedRepository, tarball, whitelist


class Tarball(unittest.TestCase):
    def setUp(self):
        self.package = whitelist.shipped(ROOT)

    def test_holds_what_ships_below_one_folder(self):
        with tarfile.open(fileobj=io.BytesIO(tarball.tarball(self.package))) as archive:
            entries = archive.getmembers()
            self.assertEqual([entry.name for entry in entries], [f"package/{path}" for path in self.package.paths])
            for entry in entries:
                path = entry.name.removeprefix("package/")
                here = ROOT / whitelist.SOURCES.get(path, path)
                self.assertEqual(archive.extractfile(entry).read(), here.read_bytes())

    def test_says_nothing_of_who_made_it(self):
        with tarfile.open(fileobj=io.BytesIO(tarball.tarball(self.package))) as archive:
            told = {(entry.mode, entry.uid, entry.gid, entry.uname, entry.gname, entry.type) for entry in archive}
        self.assertEqual(told, {(0o644, 0, 0, "", "", tarfile.REGTYPE)})


class TwoRuns(CopiedRepository):
    def made(self, output):
        self.assert_run(0, "--output", output)
        (path,) = output.iterdir()
        return path.name, path.read_bytes()

    def test_give_the_same_bytes(self):
        first = self.made(self.outside / "first")
        for number, path in enumerate(self.sources()):
            os.utime(self.folder / path, (number, number))
            (self.folder / path).chmod(0o700)
        self.assertEqual(self.made(self.outside / "second"), first)

    def test_give_other_bytes_for_another_file(self):
        first = self.made(self.outside / "first")
        self.write("Documentation~/made.md", "Made.\n")
        self.assertNotEqual(self.made(self.outside / "second"), first)


class Whitelist(unittest.TestCase):
    def assert_named(self, entries, named, others):
        self.assertEqual([path for path in (*named, *others) if whitelist.Whitelist(entries).names(path)], list(named))

    def test_files_and_folders(self):
        self.assert_named(["a.txt", "A/"], ["a.txt", "A/b", "A/c/d"], ["a_txt", "b/a.txt", "A", "AB/c", "B/A/c"])

    def test_stars(self):
        self.assert_named(["A/*.md", "B/**/*.png", "*.txt"], ["A/a.md", "B/b.png", "B/c/d/e.png", "f.txt"],
                          ["A/b/c.md", "C/B/b.png", "A/f.txt"])

    def test_later_entries_win(self):
        self.assert_named(["A/", "!A/**/x", "A/b/x"], ["A/a", "A/b/x"], ["A/x", "A/c/x"])

    def test_what_npm_does_whatever_the_list_says(self):
        self.assert_named(["A/", "!README.md"], ["package.json", "README.md", "LICENSE.md.meta", "A/a~/b"],
                          ["A/.a.swp", "A/.DS_Store", "A/a.orig", "A/._a", "A/CVS/a", "CHANGELOG.md", "B/README.md"])


if __name__ == "__main__":
    unittest.main()
