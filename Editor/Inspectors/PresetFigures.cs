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
                new PresetFigure(0.53f, 0.135f, 12.7f),
                new PresetFigure(2f, 0.097f, 13.3f),
                new PresetFigure(5f, 0.098f, 13.8f),
            },
            new[]  // Preset Medium: PCSS 8+16
            {
                new PresetFigure(0.53f, 0.131f, 15.9f),
                new PresetFigure(2f, 0.079f, 17.5f),
                new PresetFigure(5f, 0.074f, 18.7f),
            },
            new[]  // Preset High: PCSS 12+24, masked
            {
                new PresetFigure(0.53f, 0.130f, 18.2f),
                new PresetFigure(2f, 0.071f, 25.0f),
                new PresetFigure(5f, 0.060f, 28.7f),
            },
            new[]  // Preset Ultra: PCSS 16+32, masked
            {
                new PresetFigure(0.53f, 0.129f, 21.9f),
                new PresetFigure(2f, 0.069f, 31.1f),
                new PresetFigure(5f, 0.054f, 36.4f),
            },
            new[]  // Preset Reference: PCSS 64+64
            {
                new PresetFigure(0.53f, 0.129f, 80.1f),
                new PresetFigure(2f, 0.066f, 91.6f),
                new PresetFigure(5f, 0.044f, 102.1f),
            },
        };
    }
}
