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
                new PresetFigure(0.53f, 0.144f, 12.6f),
                new PresetFigure(2f, 0.101f, 13.1f),
                new PresetFigure(5f, 0.101f, 13.5f),
            },
            new[]  // Penumbra Medium
            {
                new PresetFigure(0.53f, 0.141f, 15.5f),
                new PresetFigure(2f, 0.086f, 16.9f),
                new PresetFigure(5f, 0.078f, 17.9f),
            },
            new[]  // Penumbra High
            {
                new PresetFigure(0.53f, 0.140f, 16.5f),
                new PresetFigure(2f, 0.081f, 23.0f),
                new PresetFigure(5f, 0.067f, 26.9f),
            },
            new[]  // Penumbra Ultra
            {
                new PresetFigure(0.53f, 0.140f, 19.4f),
                new PresetFigure(2f, 0.079f, 28.1f),
                new PresetFigure(5f, 0.062f, 33.6f),
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
