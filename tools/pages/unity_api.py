"""The table of docs/unity-api.md: what the reports of scripts/check-unity-api say."""
from figures import DOCS, RESULTS, read_json
from markdown import table

GENERATIONS = ("2022.3", "6000.0", "6000.5")
COUNTS = {"types": "types", "declarations": "declarations", "inherited": "of which inherited",
          "byName": "compared by name only", "obsolete": "obsolete", "differences": "differences"}


def row(report):
    sources = ", ".join("{source} {version} ({files} files)".format(**source) for source in report["sources"])
    return [report["generation"], sources, *(report["counts"][key] for key in COUNTS)]


def listed(report):
    """What the counts are of, where it is worth a look."""
    def of_types(key):
        return list(dict.fromkeys(name for one in report["types"] for name in one.get(key, [])))

    for title, lines in (("Differences in {}:", report["problems"]),
                         ("Obsolete in {}, with a warning:", of_types("obsolete")),
                         ("Compared by name only in {}:", of_types("byName"))):
        if lines:
            entries = "\n".join(f"- {line}" for line in lines).replace("<", "\\<").replace("|", "\\|")
            yield f"\n\n{title.format(report['generation'])}\n\n{entries}"


def parts(_):
    reports = [read_json(RESULTS / f"api-check-{generation}.json") for generation in GENERATIONS]
    text = table(["Unity", "compared with", *COUNTS.values()], map(row, reports), 2)
    return {DOCS / "unity-api.md": {"api-check": text + "".join(part for one in reports for part in listed(one))}}
