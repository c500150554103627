"""The quality presets' figures as C#, which their inspector shows."""
from figures import ROOT, all_fetches, distinct, groups, mean, read
from markdown import Problem

FILE = ROOT / "Editor" / "Inspectors" / "PresetFigures.cs"
PREFIX = "preset-"
TEXT = """namespace Penumbra.Editor
{{
    // Means over {scenes} scenes; Documentation~/presets.md says how they were measured.
    // Written by scripts/pages from Documentation~/results/presets/results.tsv; do not edit.
    internal static class PresetFigures
    {{
        /// <summary>One row per preset, in QualityPreset's order; by ascending angular diameter.</summary>
        internal static readonly PresetFigure[][] Rows =
        {{
{rows}
        }};
    }}
}}
"""


def figure(light, records, scenes):
    error, fetches = ([key(record) for record in records] for key in (lambda each: each["rmse_penumbra"], all_fetches))
    if len(records) != scenes or None in error + fetches:
        raise Problem(f"{records[0]['technique']} was not measured on every scene: measure all presets on the same ones")
    return f"                new PresetFigure({light:g}f, {mean(error):.3f}f, {mean(fetches):.1f}f),"


def preset_figures(results):
    presets = [record for record in results["records"] if record["technique"].startswith(PREFIX)]
    if not presets:
        raise Problem(f"no quality preset was measured: their names begin with {PREFIX}")
    scenes = len(distinct(results["records"], "scene"))
    rows = []
    for (title,), own in groups(presets, "title"):
        by_light = sorted(groups(own, "light_degrees"))
        rows += [f"            new[]  // {title}", "            {",
                 *(figure(light, records, scenes) for (light,), records in by_light), "            },"]
    return TEXT.format(scenes=scenes, rows="\n".join(rows))


def parts(_program):
    return {FILE: preset_figures(read("presets"))}
