namespace Penumbra.Editor
{
    // Means over 12 scenes; Documentation~/presets.md says how they were measured.
    // Written by `penumbra measure --presets` from Documentation~/results/presets/results.json; do not edit.
    internal static class PresetFigures
    {
        /// <summary>One row per preset, in QualityPreset's order; by ascending angular diameter.</summary>
        internal static readonly PresetFigure[][] Rows =
        {
            new[]  // Penumbra Low
            {
                new PresetFigure(0.53f, 0.158f, 10.5f),
                new PresetFigure(2f, 0.094f, 16.8f),
                new PresetFigure(5f, 0.069f, 23.9f),
            },
            new[]  // Penumbra Medium
            {
                new PresetFigure(0.53f, 0.134f, 8.0f),
                new PresetFigure(2f, 0.072f, 16.4f),
                new PresetFigure(5f, 0.055f, 27.0f),
            },
            new[]  // Penumbra High
            {
                new PresetFigure(0.53f, 0.133f, 8.0f),
                new PresetFigure(2f, 0.071f, 16.7f),
                new PresetFigure(5f, 0.053f, 27.5f),
            },
            new[]  // Penumbra Ultra
            {
                new PresetFigure(0.53f, 0.133f, 8.1f),
                new PresetFigure(2f, 0.070f, 17.0f),
                new PresetFigure(5f, 0.052f, 28.1f),
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
