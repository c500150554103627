namespace Penumbra.Editor
{
    // Means over 7 scenes; Documentation~/presets.md says how they were measured.
    // Written by `penumbra measure --presets` from Documentation~/results/presets/results.json; do not edit.
    internal static class PresetFigures
    {
        /// <summary>By preset, in QualityPreset's order; lights rise.</summary>
        internal static readonly PresetFigure[][] Rows =
        {
            new[]  // Preset Low: tent 5 x 5
            {
                new PresetFigure(0.53f, 0.164f, 14.1f),
                new PresetFigure(2f, 0.197f, 14.1f),
                new PresetFigure(5f, 0.232f, 14.1f),
            },
            new[]  // Preset Medium: PCSS 12+8, masked
            {
                new PresetFigure(0.53f, 0.138f, 17.0f),
                new PresetFigure(2f, 0.099f, 21.0f),
                new PresetFigure(5f, 0.100f, 21.8f),
            },
            new[]  // Preset High: PCSS 24+16, masked
            {
                new PresetFigure(0.53f, 0.133f, 26.9f),
                new PresetFigure(2f, 0.077f, 33.8f),
                new PresetFigure(5f, 0.069f, 35.4f),
            },
            new[]  // Preset Ultra: PCSS 24+16, masked and denoised
            {
                new PresetFigure(0.53f, 0.137f, 39.1f),
                new PresetFigure(2f, 0.071f, 46.7f),
                new PresetFigure(5f, 0.055f, 49.8f),
            },
            new[]  // Preset Reference: PCSS 64+64
            {
                new PresetFigure(0.53f, 0.131f, 85.7f),
                new PresetFigure(2f, 0.066f, 88.2f),
                new PresetFigure(5f, 0.046f, 91.1f),
            },
        };
    }
}
