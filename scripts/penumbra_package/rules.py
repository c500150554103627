"""All rules on a package; the answers are sorted by place, so that the same package gives the same report."""
from . import (assembly_rules, changelog_rules, include_rules, link_rules, manifest_rules, meta_rules, path_rules,
               picture_rules, source_rules)


def problems(package, roots):
    """`roots` are folders of other packages by their name."""
    found = [*path_rules.check(package), *meta_rules.check(package), *manifest_rules.check(package),
             *assembly_rules.check(package), *include_rules.check(package, roots), *changelog_rules.check(package),
             *link_rules.check(package), *picture_rules.check(package)]
    found = [problem._replace(path=package.source(problem.path)) for problem in found]
    return sorted(found, key=lambda problem: (problem.path, problem.line, problem.column, problem.text))


def source_problems(root, package, roots):
    """Of the work tree that the package is made from."""
    return [*source_rules.check(root, package), *problems(package, roots)]
