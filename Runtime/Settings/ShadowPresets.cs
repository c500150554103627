namespace Penumbra
{
    /// <summary>
    /// The options behind each preset's name (PresetTable). What they cost and how wrong they are stands in
    /// Documentation~/presets.md and in the feature's inspector.
    /// </summary>
    public static class ShadowPresets
    {
        /// <summary>Custom has no options of its own: it begins as Medium.</summary>
        public static ShadowOptions Options(QualityPreset preset) =>
            PresetTable.Rows[(int)(preset == QualityPreset.Custom ? QualityPreset.Medium : preset)];
    }
}
