namespace Penumbra.Tests
{
    /// <summary>
    /// Draws presets as devices that cannot run Cell PCSS do: with PCSS in the passes over the screen. It serves
    /// tests whose subject is those passes, not the presets.
    /// </summary>
    internal static class PresetFallback
    {
        internal static ShadowOptions Options(QualityPreset preset)
        {
            ShadowOptions options = ShadowPresets.Options(preset);
            options.technique = ShadowTechnique.Pcss;
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
