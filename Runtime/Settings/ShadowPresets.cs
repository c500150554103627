namespace Penumbra
{
    /// <summary>
    /// Has the options of each preset (PresetTable). The presets' cost and error are listed in
    /// Documentation~/presets.md and in the feature's inspector.
    /// </summary>
    public static class ShadowPresets
    {
        /// <summary>
        /// The preset's options. Custom has none of its own: it starts as Medium. No preset has contact shadows; their
        /// steps are those that the study measures.
        /// </summary>
        public static ShadowOptions Options(QualityPreset preset)
        {
            ShadowOptions options = PresetTable.Rows[(int)(preset == QualityPreset.Custom ? QualityPreset.Medium : preset)];
            options.contactShadowSteps = ScreenTraceParameters.Default.traceSteps;
            return options;
        }
    }
}
