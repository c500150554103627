"""scripts/package --branch commits the package's files alone, and nothing else of the repository changes."""
import json
import subprocess
import unittest

from scratch import CopiedRepository, environment, whitelist

TOOL = "tools/made/made.txt"
README = whitelist.SOURCES["README.md"]


class Branch(CopiedRepository):
    def fill(self):
        super().fill()
        self.write(TOOL, "not the package's\n")
        self.write(".gitignore", "/build/\n")
        self.git("init", "--quiet", "--initial-branch=main")
        self.commit("First")
        self.version = json.loads(self.text("package.json"))["version"]

    def git(self, *words, folder=None):
        done = subprocess.run(["git", "-C", str(folder or self.folder), *words], capture_output=True, text=True,
                              check=False, env=environment())
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.strip()

    def commit(self, message):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message", message)

    def test_holds_the_packages_files(self):
        done = self.assert_run(0, "--branch", "upm")
        self.assertEqual(done.stdout.splitlines()[0], f"upm: {self.git('rev-parse', 'upm')}")
        listed = {line.split("\t")[1]: line.split()[0] for line in self.git("ls-tree", "-r", "upm").splitlines()}
        self.assertEqual(listed, {path: "100644" for path in whitelist.shipped(self.folder).paths})
        self.assertEqual(self.git("diff", "--name-only", "main", "upm", "--", *listed), "README.md")
        self.assertEqual(self.git("rev-parse", "upm:README.md"), self.git("rev-parse", f"main:{README}"))
        self.assertEqual(self.git("log", "-1", "--format=%B", "upm"),
                         f"com.penumbra.shadows {self.version}\n\n"
                         f"The package's files of commit {self.git('rev-parse', 'main')}.")

    def test_touches_neither_the_work_tree_nor_the_index(self):
        self.write("untracked.txt", "")
        self.write(TOOL, "changed, and none of the package's\n")
        self.git("add", TOOL)
        def state():
            files = {path: text for path, text in self.contents().items() if not path.startswith(".git/")}
            return files, self.git("status", "--porcelain"), self.git("rev-parse", "HEAD"), self.git("ls-files", "--stage")

        before = state()
        self.assert_run(0, "--branch", "upm", "--output", self.outside)
        self.assertEqual(state(), before)

    def test_the_same_files_make_no_second_commit(self):
        self.assert_run(0, "--branch", "upm")
        first = self.git("rev-parse", "upm")
        self.write(TOOL, "changed\n")
        self.commit("Second")
        self.assertIn("upm: has these files already\n", self.assert_run(0, "--branch", "upm").stdout)
        self.assertEqual(self.git("rev-parse", "upm"), first)

    def test_a_change_follows_the_commit_before(self):
        self.assert_run(0, "--branch", "upm")
        first = self.git("rev-parse", "upm")
        self.write("Documentation~/made.md", "Made.\n")
        self.commit("Second")
        self.assert_run(0, "--branch", "upm")
        self.assertEqual(self.git("rev-parse", "upm^"), first)
        self.assertEqual(self.git("diff", "--name-only", "upm^", "upm"), "Documentation~/made.md")

    def test_everybody_makes_the_same_commit(self):
        other = self.outside / "clone"
        self.git("clone", "--quiet", str(self.folder), str(other))
        self.assert_run(0, "--branch", "upm", GIT_AUTHOR_NAME="Other", GIT_COMMITTER_DATE="2027-01-01T00:00:00Z")
        mine, self.folder = self.git("rev-parse", "upm"), other
        self.assert_run(0, "--branch", "upm")
        self.assertEqual(self.git("rev-parse", "upm"), mine)

    def test_a_clone_of_it_is_the_package(self):
        self.assert_run(0, "--branch", "upm")
        clone = self.outside / "installed"
        self.git("clone", "--quiet", "--branch", "upm", str(self.folder), str(clone))
        self.assertEqual({path.relative_to(clone).as_posix(): path.read_bytes() for path in clone.rglob("*")
                          if path.is_file() and ".git" not in path.parts},
                         {path: self.shipped(path) for path in whitelist.shipped(self.folder).paths})

    def test_what_is_not_committed_is_refused(self):
        text = "differs from HEAD: commit it first, as the branch says what commit it is of"
        unlinked = "Documentation~/unlinked.md"
        self.write(unlinked, "No page leads here.\n")
        self.commit("Second")
        self.write("Documentation~/made.md", "")
        self.assert_refused(1, f"scripts/package: Documentation~/made.md: {text}", "--branch", "upm")
        self.write("README.md", "The repository's own, which is none of the package's.\n")
        self.assert_refused(1, f"scripts/package: Documentation~/made.md: {text}", "--branch", "upm")
        self.write(README, self.text(README) + "\nMore.\n")
        self.assert_refused(1, f"scripts/package: Documentation~/made.md and 1 more: {text}", "--branch", "upm")
        (self.folder / "Documentation~/made.md").unlink()
        self.git("checkout", "--quiet", "README.md", README)
        (self.folder / unlinked).unlink()
        self.assert_refused(1, f"scripts/package: {unlinked}: {text}", "--branch", "upm")
        self.assertEqual(self.git("branch", "--list", "upm"), "")

    def test_branches_of_other_things_stay(self):
        self.git("branch", "other")
        for branch, message in (("main", "is checked out: check out another branch, or choose another"),
                                ("other", "exists and contains no package: choose another"),
                                ("a..b", "is not a branch name: use upm")):
            self.assert_refused(2, f"scripts/package: --branch {branch}: {message}", "--branch", branch)
        self.assertEqual(self.git("rev-parse", "main"), self.git("rev-parse", "other"))
        self.assertFalse((self.folder / "build").exists())

    def test_what_git_refuses_is_told(self):
        self.write(".git/refs/heads/upm.lock", "")
        done = self.assert_run(3, "--branch", "upm")
        self.assertRegex(done.stderr, r"^scripts/package: git update-ref: .*upm\.lock")
        self.assertFalse((self.folder / "build").exists())

    def test_a_broken_rule_makes_no_branch(self):
        (self.folder / "Runtime.meta").unlink()
        self.commit("Broken")
        self.assert_run(1, "--branch", "upm")
        self.assertEqual(self.git("branch", "--list", "upm"), "")


class NoRepository(CopiedRepository):
    def test_is_refused(self):
        self.assert_refused(3, "scripts/package: --branch needs the project's git repository: "
                            "clone the project instead of downloading it", "--branch", "upm",
                            GIT_CEILING_DIRECTORIES=str(self.outside))

    def test_without_a_commit_is_refused(self):
        subprocess.run(["git", "init", "--quiet", str(self.folder)], check=True, env=environment())
        self.assert_refused(1, "scripts/package: --branch needs a commit of the files: commit them first", "--branch", "upm")

    def test_without_git_is_refused(self):
        self.assert_refused(3, "scripts/package: --branch needs git, which is not installed", "--branch", "upm",
                            PATH=str(self.outside))


if __name__ == "__main__":
    unittest.main()
