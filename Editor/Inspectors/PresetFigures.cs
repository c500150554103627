namespace Penumbra.Editor
{
    // Means over 12 scenes; Documentation~/presets.md says how they were measured.
    // Written by scripts/pages from Documentation~/results/presets/results.tsv; do not edit.
    internal static class PresetFigures
    {
        /// <summary>One row per preset, in QualityPreset's order; by ascending angular diameter.</summary>
        internal static readonly PresetFigure[][] Rows =
        {
            new[]  // Penumbra Low
            {
                new PresetFigure(0.53f, 0.152f, 14.1f),
                new PresetFigure(2f, 0.090f, 18.0f),
                new PresetFigure(5f, 0.073f, 21.8f),
            },
            new[]  // Penumbra Medium
            {
                new PresetFigure(0.53f, 0.135f, 24.6f),
                new PresetFigure(2f, 0.072f, 34.5f),
                new PresetFigure(5f, 0.055f, 45.4f),
            },
            new[]  // Penumbra High
            {
                new PresetFigure(0.53f, 0.135f, 30.1f),
                new PresetFigure(2f, 0.071f, 45.3f),
                new PresetFigure(5f, 0.053f, 61.4f),
            },
            new[]  // Penumbra Ultra
            {
                new PresetFigure(0.53f, 0.135f, 39.1f),
                new PresetFigure(2f, 0.071f, 64.4f),
                new PresetFigure(5f, 0.053f, 91.1f),
            },
            new[]  // Penumbra Reference
            {
                new PresetFigure(0.53f, 0.135f, 57.1f),
                new PresetFigure(2f, 0.071f, 102.9f),
                new PresetFigure(5f, 0.052f, 151.1f),
            },
        };
    }
}
