namespace Penumbra
{
    /// <summary>
    /// The cost per pixel. All draw Tiled PCSS, or its filter alone on devices that cannot run it. Error and
    /// fetches of each preset are measured against ray tracing and shown in the inspector (PresetFigures).
    /// </summary>
    public enum QualityPreset
    {
        Low,
        Medium,
        High,
        Ultra,

        /// <summary>The best picture that the shadow map allows, for comparison; not for games.</summary>
        Reference,

        /// <summary>The options are set by hand, each of them.</summary>
        Custom,
    }

    /// <summary>Whether the noise that rotates each pixel's sample disk changes per frame.</summary>
    public enum NoiseMode
    {
        /// <summary>
        /// The pattern is fixed on the screen. This is the right choice unless something averages frames.
        /// </summary>
        Static,

        /// <summary>The pattern is new in every frame, for temporal antialiasing or upscaling to average.</summary>
        PerFrame,

        /// <summary>
        /// The pattern is new in every frame, and a pass of the feature averages the frames; for projects without
        /// temporal antialiasing.
        /// </summary>
        Accumulated,
    }
}
