namespace Penumbra.Editor
{
    // Means over 7 scenes; Documentation~/presets.md says how they were measured.
    // Written by `penumbra measure --presets` from Documentation~/results/presets/results.json; do not edit.
    internal static class PresetFigures
    {
        /// <summary>By preset, in QualityPreset's order; lights rise.</summary>
        internal static readonly PresetFigure[][] Rows =
        {
            new[]  // Preset Low: PCSS 6+8
            {
                new PresetFigure(0.53f, 0.136f, 12.7f),
                new PresetFigure(2f, 0.100f, 13.3f),
                new PresetFigure(5f, 0.101f, 13.8f),
            },
            new[]  // Preset Medium: PCSS 8+16
            {
                new PresetFigure(0.53f, 0.132f, 15.9f),
                new PresetFigure(2f, 0.082f, 17.5f),
                new PresetFigure(5f, 0.078f, 18.7f),
            },
            new[]  // Preset High: PCSS 12+24, masked
            {
                new PresetFigure(0.53f, 0.131f, 18.1f),
                new PresetFigure(2f, 0.075f, 24.9f),
                new PresetFigure(5f, 0.065f, 28.6f),
            },
            new[]  // Preset Ultra: PCSS 16+32, masked
            {
                new PresetFigure(0.53f, 0.130f, 21.8f),
                new PresetFigure(2f, 0.072f, 31.0f),
                new PresetFigure(5f, 0.059f, 36.3f),
            },
            new[]  // Preset Reference: PCSS 64+64
            {
                new PresetFigure(0.53f, 0.130f, 80.0f),
                new PresetFigure(2f, 0.070f, 91.4f),
                new PresetFigure(5f, 0.051f, 101.8f),
            },
        };
    }
}
