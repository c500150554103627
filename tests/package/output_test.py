"""The tests say what scripts/package writes and where, and that it writes nothing when it stops."""
import json
import unittest

from scratch import CopiedRepository, Folder, rules, unpacked, whitelist

from penumbra_package.problem import Stop
from penumbra_package.whole_file import write_folder


class Output(CopiedRepository):
    def fill(self):
        super().fill()
        self.output = self.outside / "output"
        self.tarball = self.output / f"com.penumbra.shadows-{json.loads(self.text('package.json'))['version']}.tgz"

    def test_the_tarball_alone(self):
        done = self.assert_run(0, "--output", self.output)
        self.assertEqual(list(self.output.iterdir()), [self.tarball])
        files, size = len(whitelist.shipped(self.folder).paths), self.tarball.stat().st_size
        self.assertEqual(done.stdout, f"{self.tarball}: {files} files, {size / 1000:.0f} kB\n")

    def test_the_folder_where_none_is_named(self):
        self.assert_run(0)
        self.assertTrue((self.folder / "build" / "package" / self.tarball.name).is_file())
        self.assertEqual(self.assert_run(0, "--check").stderr, "")  # what is made does not become part of the package

    def test_the_folder_of_the_branch(self):
        self.assert_run(0, "--output", self.output, "--upm")
        made = unpacked(self.output / "upm")
        self.assertEqual(made.paths, whitelist.shipped(self.folder).paths)
        self.assertTrue(all(made.bytes(path) == self.shipped(path) for path in made.paths))
        self.assertEqual(rules.problems(made, {}), [])

    def test_an_earlier_folder_gives_way(self):
        self.assert_run(0, "--output", self.output, "--upm")
        (self.output / "upm" / "old.txt").write_text("")
        self.assert_run(0, "--output", self.output, "--upm")
        self.assertFalse((self.output / "upm" / "old.txt").exists())
        self.assertEqual(sorted(path.name for path in self.output.iterdir()), sorted([self.tarball.name, "upm"]))

    def test_a_folder_of_somebody_else_stays(self):
        (self.output / "upm").mkdir(parents=True)
        (self.output / "upm" / "mine.txt").write_text("mine")
        self.assert_refused(2, f"scripts/package: {self.output / 'upm'}: exists and is not a package: "
                            "remove it, or choose another --output", "--output", self.output, "--upm")
        self.assertEqual([path.name for path in self.output.rglob("*")], ["upm", "mine.txt"])

    def test_nothing_is_written_where_a_rule_is_broken(self):
        (self.folder / "Runtime.meta").unlink()
        self.assert_refused(1, "Runtime: has no Runtime.meta in the package: run scripts/package --metas\n"
                            "scripts/package: 1 problem; nothing is packed", "--output", self.output, "--upm")
        self.assertFalse(self.output.exists())

    def test_a_check_writes_nothing(self):
        before = self.contents()
        self.assert_run(0, "--check", "--output", self.output)
        self.assertFalse(self.output.exists())
        self.assertEqual(self.contents(), before)

    def test_a_place_that_cannot_be_written(self):
        self.output.write_text("")
        self.assert_refused(2, f"scripts/package: {self.tarball}: cannot be written: File exists", "--output", self.output)
        self.output.unlink()
        self.tarball.mkdir(parents=True)
        self.assert_refused(2, f"scripts/package: {self.tarball}: cannot be written: Is a directory", "--output", self.output)
        self.assertEqual(list(self.output.iterdir()), [self.tarball])

    def test_options_that_do_not_go_together(self):
        for words in (("--check", "--metas"), ("--check", "--upm"), ("--metas", "--branch", "upm"), ("--nothing",)):
            self.assertIn("usage: scripts/package", self.assert_run(2, *words).stderr)


class WholeFolder(Folder):
    def test_one_that_cannot_be_written_leaves_the_earlier(self):
        target = self.folder / "upm"
        write_folder(target, {"a/b.txt": b"earlier"})
        with self.assertRaisesRegex(Stop, f"^{target}: cannot be written: "):
            write_folder(target, {"a": b"", "a/b.txt": b""})
        self.assertEqual(self.text("upm/a/b.txt"), "earlier")
        self.assertEqual(list(self.folder.iterdir()), [target])

    def test_one_below_a_file(self):
        self.write("file", "")
        with self.assertRaisesRegex(Stop, f"^{self.folder}/file/upm: cannot be written: "):
            write_folder(self.folder / "file" / "upm", {})


if __name__ == "__main__":
    unittest.main()
