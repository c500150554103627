namespace Penumbra
{
    /// <summary>
    /// What inspectors say of each option: one text for the feature, its custom options and the Volume. Each says unit and
    /// range where there is one.
    /// </summary>
    internal static class OptionTooltips
    {
        internal const string Quality =
            "How much is spent on a pixel: sets all options except the light's look. Custom has every option set by hand.";

        internal const string Look =
            "How the light looks: sets Angular Diameter and Softness Cap. The sun's real disc is 0.53 degrees wide; wider " +
            "ones stand in for haze and cloud.";

        internal const string Technique =
            "The filter. Tents blur by a fixed number of shadow map texels. PCSS is sharp at contacts and widens with " +
            "distance. PCSS (HDRP) follows the rules and limits of Unity's HDRP.";

        internal const string AngularDiameter =
            "Full angle of the light's disc in degrees, 0 to 30. The sun's is 0.53. A larger disc makes wider penumbrae.";

        internal const string BlockerSamples =
            "Texture fetches per pixel that look for what casts the shadow, 1 to 64. Too few miss thin casters. PCSS " +
            "(Poisson) takes as many again for its filter.";

        internal const string FilterSamples =
            "Texture fetches per pixel that measure how much of the light is seen, 1 to 64. Too few are grainy.";

        internal const string SoftnessCap =
            "Widest penumbra in metres, full width, 0 to 100. Wider ones are drawn this wide.";

        internal const string MinFilter =
            "Smallest filter radius in texels of the shadow map, 0 to 8. Hides the map's texels at contacts; light leaks in " +
            "there if it is large.";

        internal const string Mask =
            "Runs the full filter only where a coarse search finds an edge; elsewhere a pixel reads the shadow map once.";

        internal const string HalfResolution =
            "Filters a quarter of the pixels, every second one along both axes, and fills in the others along edges.";

        internal const string Denoise = "Smooths the grain of the samples along surfaces, and not across their edges.";

        internal const string DebugView =
            "Drawn over the picture in the editor and in development builds: visibility, cascades, shadow map texels, " +
            "penumbra width or mask.";
    }
}
