namespace Penumbra.Editor
{
    // Means over 12 scenes; Documentation~/presets.md says how they were measured.
    // Written by `penumbra measure --presets` from Documentation~/results/presets/results.tsv; do not edit.
    internal static class PresetFigures
    {
        /// <summary>One row per preset, in QualityPreset's order; by ascending angular diameter.</summary>
        internal static readonly PresetFigure[][] Rows =
        {
            new[]  // Penumbra Low
            {
                new PresetFigure(0.53f, 0.152f, 14.3f),
                new PresetFigure(2f, 0.091f, 18.1f),
                new PresetFigure(5f, 0.077f, 21.8f),
            },
            new[]  // Penumbra Medium
            {
                new PresetFigure(0.53f, 0.134f, 25.5f),
                new PresetFigure(2f, 0.074f, 34.1f),
                new PresetFigure(5f, 0.058f, 44.1f),
            },
            new[]  // Penumbra High
            {
                new PresetFigure(0.53f, 0.134f, 33.2f),
                new PresetFigure(2f, 0.071f, 46.4f),
                new PresetFigure(5f, 0.052f, 61.7f),
            },
            new[]  // Penumbra Ultra
            {
                new PresetFigure(0.53f, 0.134f, 45.5f),
                new PresetFigure(2f, 0.071f, 66.7f),
                new PresetFigure(5f, 0.051f, 91.6f),
            },
            new[]  // Penumbra Reference
            {
                new PresetFigure(0.53f, 0.134f, 70.3f),
                new PresetFigure(2f, 0.071f, 107.6f),
                new PresetFigure(5f, 0.051f, 152.2f),
            },
        };
    }
}
