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
                new PresetFigure(0.53f, 0.158f, 10.6f),
                new PresetFigure(2f, 0.094f, 16.9f),
                new PresetFigure(5f, 0.069f, 24.0f),
            },
            new[]  // Penumbra Medium
            {
                new PresetFigure(0.53f, 0.134f, 8.5f),
                new PresetFigure(2f, 0.072f, 17.2f),
                new PresetFigure(5f, 0.055f, 28.1f),
            },
            new[]  // Penumbra High
            {
                new PresetFigure(0.53f, 0.133f, 8.6f),
                new PresetFigure(2f, 0.071f, 17.5f),
                new PresetFigure(5f, 0.053f, 28.6f),
            },
            new[]  // Penumbra Ultra
            {
                new PresetFigure(0.53f, 0.133f, 8.7f),
                new PresetFigure(2f, 0.070f, 17.8f),
                new PresetFigure(5f, 0.052f, 29.1f),
            },
            new[]  // Penumbra Reference
            {
                new PresetFigure(0.53f, 0.139f, 77.4f),
                new PresetFigure(2f, 0.077f, 86.8f),
                new PresetFigure(5f, 0.055f, 95.4f),
            },
        };
    }
}
