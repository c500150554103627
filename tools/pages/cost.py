"""The table of a few techniques' cost in docs/cost.md, as Unity runs them on these GPUs: with reversed Z."""
from figures import DOCS, RESULTS, code, read_json
from markdown import table

TECHNIQUES = ("hard", "tent-3", "tent-5", "tent-7", "pcss-poisson-25", "pcss-angular-24-16")
BYTECODE = "d3d11"  # the family that has no cycles
FIGURES = (("instructions", "instructions"), ("inverse_throughput_cycles", "cycles per 64 lanes"))


def figure(report, family, technique, key):
    wanted = {"technique": technique, "keywords": ["UNITY_REVERSED_Z"]}
    rows = [row for row in report["rows"] if row["family"] == family and wanted in row["variants"]]
    found = rows[0].get("figures", {}).get(key) if rows else None
    return "-" if found is None else found


def summary(report):
    drivers = {family["name"]: family["driver"] for family in report["families"]}
    columns = [(family, key, f"{what}, {family}") for key, what in FIGURES for family in drivers
               if key == "instructions" or family != BYTECODE]
    bytecode = f" Direct3D: {drivers[BYTECODE]}." if BYTECODE in drivers else ""
    rows = [[technique, *(figure(report, family, technique, key) for family, key, _ in columns)]
            for technique in TECHNIQUES]
    return (f"Driver: {report['driver']}, without hardware. SPIR-V: {report['compiler']}.{bytecode}  \nCommand:"
            f" {code(report['command'])}\n\n" + table(["Technique", *(head for *_, head in columns)], rows, 1))


def parts(_program):
    return {DOCS / "cost.md": {"cost-summary": summary(read_json(RESULTS / "cost.json"))}}
