namespace Penumbra
{
    /// <summary>
    /// The options of each preset (PresetTable). Their cost and error are listed in Documentation~/presets.md and in
    /// the feature's inspector.
    /// </summary>
    public static class ShadowPresets
    {
        /// <summary>Custom has no options of its own: it starts as Medium.</summary>
        public static ShadowOptions Options(QualityPreset preset) =>
            PresetTable.Rows[(int)(preset == QualityPreset.Custom ? QualityPreset.Medium : preset)];
    }
}
