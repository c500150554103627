"""What docs/command-line.md and docs/cpp-library.md say of the program, from its own help."""
import subprocess

from figures import DOCS, code
from markdown import Problem, table


def output(program, *arguments, folder=None):
    run = subprocess.run([program, *arguments], capture_output=True, text=True, cwd=folder)
    if run.returncode != 0:
        raise Problem(f"penumbra {' '.join(arguments)} ended with {run.returncode}: {run.stderr.strip()}")
    return run.stdout.strip()


def subcommands(program):
    """The names below "Subcommands:" of the program's help."""
    lines = output(program, "--help").split("Subcommands:\n")[1].split("\n\n")[0].splitlines()
    return [line.split()[0] for line in lines if line.startswith("  ") and not line.startswith("   ")]


def in_cell(text):
    return text.replace("|", "\\|")


def option_rows(lines):
    """A row for each option or positional below a heading of the help; what is said of it may go on in deeper lines."""
    rows = []
    for line in lines:
        if line.startswith(" " * 20):
            rows[-1][1] = f"{rows[-1][1]} {line.strip()}".strip()
        else:
            name, _, text = line.strip().partition("  ")
            rows.append([name, text.strip()])
    return [[in_cell(code(name)), in_cell(text).replace("<", "&lt;")] for name, text in rows if name != "-h, --help"]


def groups_of(what):
    """(heading, option rows) of each group of a subcommand's help, and its remarks."""
    groups, remarks = [], []
    for group in what.split("\n\n")[1:]:
        heading, *options = group.strip("\n").splitlines()
        if heading.endswith(":"):
            groups.append((heading.removesuffix(":"), option_rows(options)))
        else:
            remarks.append(" ".join(line.strip() for line in [heading, *options]).replace("<", "&lt;"))
    return groups, remarks


def parts_of(text):
    """A subcommand's help: what it does with its options, and its examples."""
    return text.split("\nExit codes:")[0].rstrip().split("\nExamples:\n")


def shared_options(helps):
    """(option, what it does): the subcommands that have it, where these are several."""
    found = {}
    for name, text in helps.items():
        for _, rows in groups_of(parts_of(text)[0])[0]:
            for row in rows:
                found.setdefault(tuple(row), []).append(name)
    return {row: names for row, names in found.items() if len(names) > 1}


def examples_of(text):
    """The commands; what is said of one in a line before it stands behind it, where both fit into a line."""
    lines = []
    for line in map(str.strip, text.splitlines()):
        if lines and lines[-1].startswith("# ") and len(lines[-1]) + len(line) < 117:
            lines[-1] = f"{line}  {lines[-1]}"
        else:
            lines.append(line)
    return lines


def subcommand(text, shared):
    """The help of a subcommand: its own options as a table, the names of the shared ones, its examples as a block of
    code."""
    what, examples = parts_of(text)
    headline, usage = what.split("\n\n")[0].splitlines()
    groups, remarks = groups_of(what)
    rows, others = [], []
    for heading, options in groups:
        own = [row for row in options if tuple(row) not in shared]
        others += [row[0] for row in options if tuple(row) in shared]
        if own and heading not in ("Options", "Positionals"):
            rows.append([f"**{heading}**", ""])
        rows += own
    also = [f"[Shared options](#shared-options): {', '.join(others)}."] if others else []
    options = [table(["option", "what it does"], rows, 2)] if rows else []
    examples = "```\n" + "\n".join(examples_of(examples)) + "\n```"
    return "\n\n".join([f"{headline}: {code(usage.removeprefix('Usage: '))}", *options, *also, *remarks, examples])


def exit_codes(program):
    lines = output(program, "--help").split("Exit codes:\n")[1].splitlines()
    return table(["exit code", "means"], [line.split(maxsplit=1) for line in lines if line.startswith("  ")], 2)


def parts(program):
    helps = {name: output(program, "help", name) for name in subcommands(program)}
    shared = shared_options(helps)
    described = "\n\n".join(f"## penumbra {name}\n\n{subcommand(text, shared)}" for name, text in helps.items())
    several = table(["option", "what it does", "of"],
                    [[*row, ", ".join(map(code, names))] for row, names in shared.items()], 3)
    return {DOCS / "command-line.md": {"exit codes": exit_codes(program), "shared options": several,
                                       "subcommands": described},
            DOCS / "cpp-library.md": {"settings": output(program, "constants", "--list-settings")}}
