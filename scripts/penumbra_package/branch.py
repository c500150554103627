"""A commit of the package's files alone on a branch of their own, for installation by git URL.

Only git's plumbing is used: neither the work tree nor its index changes. The commit's files are those of the source
commit, and so are its author and time: from the same source commit everybody makes the same commit.
"""
import os
import subprocess
import tempfile

from .package import NAME
from .problem import Stop
from .whitelist import read_whitelist

OF_A_HOOK = ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX")  # a hook's variables name another tree


class Repository:
    def __init__(self, root):
        self.root = root

    def git(self, *words, given=None, index=None, fails=False, **identity):
        """What git answers; with `fails` an exit code other than 0 is an answer, too: None."""
        outside = {name: value for name, value in os.environ.items() if name not in OF_A_HOOK}
        environment = {**outside, **identity, **({"GIT_INDEX_FILE": index} if index else {})}
        try:
            done = subprocess.run(["git", "-C", str(self.root), *words], input=given, capture_output=True, check=False,
                                  text=True, env=environment)
        except FileNotFoundError as error:
            raise Stop("--branch needs git, which is not installed", 3) from error
        if done.returncode == 0:
            return done.stdout
        if fails:
            return None
        raise Stop(f"git {words[0]}: {done.stderr.strip()}", 3)

    def files_of(self, commit):
        """Mode and object by path."""
        entries = (line.split("\t", 1) for line in self.git("ls-tree", "-r", "-z", commit).split("\0") if line)
        return {path: entry.split()[::2] for entry, path in entries}

    def tree(self, files):
        lines = "".join(f"{mode} {name}\t{path}\0" for path, (mode, name) in files.items())
        with tempfile.TemporaryDirectory() as folder:
            index = os.path.join(folder, "index")
            self.git("update-index", "-z", "--index-info", given=lines, index=index)
            return self.git("write-tree", index=index).strip()


def committed_files(repository, package):
    """The objects of the package's files in HEAD, which must be what lies in the work tree."""
    whitelist = read_whitelist(package.root)
    committed = repository.files_of("HEAD")
    wanted = package.files | {path for path in committed if whitelist.names(path)}
    in_head = {path: committed[package.source(path)] for path in wanted if package.source(path) in committed}
    changed = set(repository.git("diff", "--name-only", "--no-renames", "-z", "HEAD", "--").split("\0"))
    differing = sorted(package.source(path) for path in wanted
                       if path not in package.files or path not in in_head or package.source(path) in changed)
    if differing:
        more = f" and {len(differing) - 1} more" if len(differing) > 1 else ""
        raise Stop(f"{differing[0]}{more}: differs from HEAD: "
                   "commit it first, as the branch says what commit it is of", 1)
    return {path: ["100644", name] for path, (_, name) in in_head.items()}


def refuse_other_branches(repository, branch, reference, tip):
    if repository.git("check-ref-format", "--branch", branch, fails=True) is None:
        raise Stop(f"--branch {branch}: is not a branch name: use upm")
    if f"branch {reference}\n" in repository.git("worktree", "list", "--porcelain"):
        raise Stop(f"--branch {branch}: is checked out: check out another branch, or choose another")
    if tip and not repository.git("log", "-1", "--format=%s", tip).startswith(f"{NAME} "):
        raise Stop(f"--branch {branch}: exists and contains no package: choose another")


def commit_to_branch(package, branch):
    """The branch's new commit, or None where it has this content already."""
    repository = Repository(package.root)
    top = repository.git("rev-parse", "--show-toplevel", fails=True)
    if top is None or not os.path.samefile(top.rstrip("\n"), package.root):
        raise Stop("--branch needs the project's git repository: clone the project instead of downloading it", 3)
    if repository.git("rev-parse", "--verify", "--quiet", "HEAD", fails=True) is None:
        raise Stop("--branch needs a commit of the files: commit them first", 1)
    reference = f"refs/heads/{branch}"
    tip = (repository.git("rev-parse", "--verify", "--quiet", f"{reference}^{{commit}}", fails=True) or "").strip()
    refuse_other_branches(repository, branch, reference, tip)
    tree = repository.tree(committed_files(repository, package))
    if tip and repository.git("rev-parse", f"{tip}^{{tree}}").strip() == tree:
        return None
    source, name, email, date = repository.git("log", "-1", "--format=%H%n%cn%n%ce%n%cI", "HEAD").splitlines()
    identity = {f"GIT_{role}_{part}": value for role in ("AUTHOR", "COMMITTER")
                for part, value in (("NAME", name), ("EMAIL", email), ("DATE", date))}
    message = f"{NAME} {package.manifest()['version']}\n\nThe package's files of commit {source}.\n"
    commit = repository.git("commit-tree", tree, *(("-p", tip) if tip else ()), given=message, **identity).strip()
    repository.git("update-ref", "-m", "scripts/package", reference, commit, tip or "0" * 40)
    return commit
