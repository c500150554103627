namespace Penumbra
{
    // Written by `penumbra validate --emit-options` from Shaders/PenumbraShadows.technique.json; do not edit.
    /// <summary>What inspectors say of each option, in the feature and in the Volume, and the ends of its range.</summary>
    internal static class OptionTable
    {
        internal static class Quality
        {
            internal const string Label = "Quality";
            internal const string Tooltip =
                "How much is spent on a pixel: sets all options except the light's look. Custom has every option " +
                "set by hand.";
        }

        internal static class Look
        {
            internal const string Label = "Look";
            internal const string Tooltip =
                "How the light looks: sets Angular Diameter and Softness Cap. The sun's real disc is 0.53 degrees " +
                "wide; wider ones stand in for haze and cloud.";
        }

        internal static class Technique
        {
            internal const string Label = "Technique";
            internal const string Tooltip =
                "The filter. Tents blur by a fixed number of shadow map texels. PCSS is sharp at contacts and " +
                "widens with distance. PCSS (HDRP) follows the rules and limits of Unity's HDRP.";
        }

        internal static class AngularDiameterDegrees
        {
            internal const string Label = "Angular Diameter";
            internal const string Tooltip =
                "Full angle of the light's disc in degrees, 0 to 30. The sun's is 0.53. A larger disc makes wider " +
                "penumbrae.";
            internal const float Min = 0.0f;
            internal const float Max = 30.0f;
        }

        internal static class BlockerSamples
        {
            internal const string Label = "Blocker Samples";
            internal const string Tooltip =
                "Texture fetches per pixel that look for what casts the shadow, 1 to 64. Too few miss thin " +
                "casters. PCSS (Poisson) takes as many again for its filter.";
            internal const int Min = 1;
            internal const int Max = 64;
        }

        internal static class FilterSamples
        {
            internal const string Label = "Filter Samples";
            internal const string Tooltip =
                "Texture fetches per pixel that measure how much of the light is seen, 1 to 64. Too few are " +
                "grainy.";
            internal const int Min = 1;
            internal const int Max = 64;
        }

        internal static class SoftnessCapMetres
        {
            internal const string Label = "Softness Cap";
            internal const string Tooltip =
                "Widest penumbra in metres, full width, 0 to 100. Wider ones are drawn this wide.";
            internal const float Min = 0.0f;
            internal const float Max = 100.0f;
        }

        internal static class MinFilterTexels
        {
            internal const string Label = "Min Filter";
            internal const string Tooltip =
                "Smallest filter radius in texels of the shadow map, 0 to 8. Hides the map's texels at contacts; " +
                "light leaks in there if it is large.";
            internal const float Min = 0.0f;
            internal const float Max = 8.0f;
        }

        internal static class Mask
        {
            internal const string Label = "Mask";
            internal const string Tooltip =
                "Runs the full filter only where a coarse search finds an edge; elsewhere a pixel reads the " +
                "shadow map once.";
        }

        internal static class HalfResolution
        {
            internal const string Label = "Half Resolution";
            internal const string Tooltip =
                "Filters a quarter of the pixels, every second one along both axes, and fills in the others along " +
                "edges.";
        }

        internal static class Denoise
        {
            internal const string Label = "Denoise";
            internal const string Tooltip =
                "Smooths the grain of the samples along surfaces, and not across their edges.";
        }

        internal static class DebugView
        {
            internal const string Label = "Debug View";
            internal const string Tooltip =
                "Drawn over the picture in the editor and in development builds: visibility, cascades, shadow map " +
                "texels, penumbra width or mask.";
        }
    }
}
