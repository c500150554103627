namespace Penumbra
{
    /// <summary>
    /// The cost per pixel. Low to Ultra draw the flagship, and PCSS on devices that cannot run it. Error and fetches of
    /// each preset are measured against ray tracing and shown in the inspector (PresetFigures).
    /// </summary>
    public enum QualityPreset
    {
        Low,
        Medium,
        High,
        Ultra,

        /// <summary>The best that the shadow map allows, for comparison; not for games.</summary>
        Reference,

        /// <summary>Every option set by hand.</summary>
        Custom,
    }

    /// <summary>Whether the noise that rotates each pixel's sample disk changes per frame.</summary>
    public enum NoiseMode
    {
        /// <summary>The pattern is fixed on the screen. The right choice unless something averages frames.</summary>
        Static,

        /// <summary>A new pattern every frame, for temporal antialiasing or upscaling to average.</summary>
        PerFrame,
    }
}
