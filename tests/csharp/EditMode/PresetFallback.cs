namespace Penumbra.Tests
{
    /// <summary>
    /// Draws PCSS with the other options of a preset, in the passes over the screen. It serves tests whose subject is
    /// those passes, not the presets. High and Ultra have the mask of four comparisons, as no preset does.
    /// </summary>
    internal static class PresetFallback
    {
        internal static ShadowOptions Options(QualityPreset preset)
        {
            ShadowOptions options = ShadowPresets.Options(preset);
            options.technique = ShadowTechnique.Pcss;
            options.mask = preset == QualityPreset.High || preset == QualityPreset.Ultra;
            return options;
        }

        /// <summary>Chooses the fallback as the feature's own options.</summary>
        internal static void Choose(PenumbraShadowsSettings settings, QualityPreset preset)
        {
            settings.preset = QualityPreset.Custom;
            settings.custom = Options(preset);
        }
    }
}
