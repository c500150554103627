namespace Penumbra
{
    /// <summary>
    /// The options of each preset (PresetTable). Their cost and error are listed in Documentation~/presets.md and in
    /// the feature's inspector.
    /// </summary>
    public static class ShadowPresets
    {
        /// <summary>
        /// Custom has no options of its own: it starts as Medium. None has contact shadows; their steps are those that
        /// the study measures.
        /// </summary>
        public static ShadowOptions Options(QualityPreset preset)
        {
            ShadowOptions options = PresetTable.Rows[(int)(preset == QualityPreset.Custom ? QualityPreset.Medium : preset)];
            options.contactShadowSteps = ScreenTraceParameters.Default.traceSteps;
            return options;
        }
    }
}
