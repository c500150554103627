namespace Penumbra
{
    /// <summary>
    /// How much is spent on a pixel. Error and fetches of each preset are measured against ray tracing and shown in
    /// the inspector (PresetFigures).
    /// </summary>
    public enum QualityPreset
    {
        Low,
        Medium,
        High,
        Ultra,

        /// <summary>The best the shadow map allows, for comparing with; not for a game.</summary>
        Reference,

        /// <summary>Every option set by hand.</summary>
        Custom,
    }

    /// <summary>Whether the noise that turns each pixel's disk moves.</summary>
    public enum NoiseMode
    {
        /// <summary>The pattern stands still on the screen. Right unless something averages frames.</summary>
        Static,

        /// <summary>A new pattern every frame, for temporal antialiasing or upscaling to average.</summary>
        PerFrame,
    }
}
