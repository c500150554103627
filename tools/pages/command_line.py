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


def subcommand(text):
    """The help of a subcommand: its options as a table, its examples as a block of code."""
    what, examples = text.split("\nExit codes:")[0].rstrip().split("\nExamples:\n")
    headline, usage = what.split("\n\n")[0].splitlines()
    rows, remarks = [], []
    for group in what.split("\n\n")[1:]:
        heading, *options = group.strip("\n").splitlines()
        if not heading.endswith(":"):
            remarks.append(" ".join(line.strip() for line in [heading, *options]).replace("<", "&lt;"))
            continue
        if heading not in ("Options:", "Positionals:"):
            rows.append([f"**{heading.removesuffix(':')}**", ""])
        rows += option_rows(options)
    options = [table(["option", "what it does"], rows, 2)] if rows else []
    examples = "```\n" + "\n".join(line.strip() for line in examples.splitlines()) + "\n```"
    return "\n\n".join([f"{headline}.", code(usage.removeprefix("Usage: ")), *options, *remarks, examples])


def exit_codes(program):
    lines = output(program, "--help").split("Exit codes:\n")[1].splitlines()
    return table(["exit code", "means"], [line.split(maxsplit=1) for line in lines if line.startswith("  ")], 2)


def parts(program):
    described = "\n\n".join(f"## penumbra {name}\n\n{subcommand(output(program, 'help', name))}"
                            for name in subcommands(program))
    return {DOCS / "command-line.md": {"exit codes": exit_codes(program), "subcommands": described},
            DOCS / "cpp-library.md": {"settings": output(program, "constants", "--list-settings")}}
