"""Every picture and every file of figures that ships is shown by a page that ships, or a page links to it.

What no page shows is weight that every project carries in its package cache and nobody sees.
"""
from . import link_rules
from .problem import Problem

PICTURES = (".png", ".jpg", ".jpeg", ".gif", ".svg", ".webp")
DATA = ("Documentation~/results/", "Documentation~/variants/")


def is_illustration(path):
    """May be left out of the package where no page of it leads there."""
    return path.startswith("Documentation~/") and path.lower().endswith(PICTURES) or path.startswith(DATA)


def check(package):
    shown = {path for page in package.ending(".md") for _, path, _ in link_rules.targets(package, page)}
    for path in package.paths:
        if is_illustration(path) and not path.endswith(".md") and path not in shown:
            yield Problem(path, f"no page of the package shows it: show it in one, or add \"!{path}\" to 'files' of "
                                "package.json")
