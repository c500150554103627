namespace Penumbra.Tests
{
    /// <summary>
    /// Presets as devices that cannot run the flagship draw them: the passes over the screen with PCSS. For tests whose
    /// subject is those passes, not the presets.
    /// </summary>
    internal static class PresetFallback
    {
        internal static ShadowOptions Options(QualityPreset preset)
        {
            ShadowOptions options = ShadowPresets.Options(preset);
            options.technique = ShadowTechnique.Pcss;
            return options;
        }

        /// <summary>As the feature's own options.</summary>
        internal static void Choose(PenumbraShadowsSettings settings, QualityPreset preset)
        {
            settings.preset = QualityPreset.Custom;
            settings.custom = Options(preset);
        }
    }
}
