using System;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraShadows.technique.json; do not edit.
    /// <summary>The options that are numbers, by the names of their fields.</summary>
    internal enum NumberOption
    {
        angularDiameterDegrees, blockerSamples, filterSamples, softnessCapMetres, minFilterTexels, lightBleeding,
        mapBlurTexels, rays, samplesPerRay, discRadiusMetres, cascadeBlend, contactShadowMetres,
        contactShadowSteps
    }

    /// <summary>Labels, tooltips and ranges of the options, for the inspectors of the feature and of the Volume.</summary>
    internal static class OptionTable
    {
        internal static float Get(in ShadowOptions options, NumberOption option)
        {
            switch (option)
            {
                case NumberOption.angularDiameterDegrees: return options.angularDiameterDegrees;
                case NumberOption.blockerSamples: return options.blockerSamples;
                case NumberOption.filterSamples: return options.filterSamples;
                case NumberOption.softnessCapMetres: return options.softnessCapMetres;
                case NumberOption.minFilterTexels: return options.minFilterTexels;
                case NumberOption.lightBleeding: return options.lightBleeding;
                case NumberOption.mapBlurTexels: return options.mapBlurTexels;
                case NumberOption.rays: return options.rays;
                case NumberOption.samplesPerRay: return options.samplesPerRay;
                case NumberOption.discRadiusMetres: return options.discRadiusMetres;
                case NumberOption.cascadeBlend: return options.cascadeBlend;
                case NumberOption.contactShadowMetres: return options.contactShadowMetres;
                case NumberOption.contactShadowSteps: return options.contactShadowSteps;
                default: throw new ArgumentOutOfRangeException(nameof(option));
            }
        }

        internal static void Set(ref ShadowOptions options, NumberOption option, float value)
        {
            switch (option)
            {
                case NumberOption.angularDiameterDegrees: options.angularDiameterDegrees = value; break;
                case NumberOption.blockerSamples: options.blockerSamples = (int)value; break;
                case NumberOption.filterSamples: options.filterSamples = (int)value; break;
                case NumberOption.softnessCapMetres: options.softnessCapMetres = value; break;
                case NumberOption.minFilterTexels: options.minFilterTexels = value; break;
                case NumberOption.lightBleeding: options.lightBleeding = value; break;
                case NumberOption.mapBlurTexels: options.mapBlurTexels = value; break;
                case NumberOption.rays: options.rays = (int)value; break;
                case NumberOption.samplesPerRay: options.samplesPerRay = (int)value; break;
                case NumberOption.discRadiusMetres: options.discRadiusMetres = value; break;
                case NumberOption.cascadeBlend: options.cascadeBlend = value; break;
                case NumberOption.contactShadowMetres: options.contactShadowMetres = value; break;
                case NumberOption.contactShadowSteps: options.contactShadowSteps = (int)value; break;
                default: throw new ArgumentOutOfRangeException(nameof(option));
            }
        }

        internal static class Quality
        {
            internal const string Label = "Quality", Tooltip =
                "The cost per pixel: sets the technique and how it filters. With Custom, every option is set by " +
                "hand.";
        }
        internal static class Look
        {
            internal const string Label = "Look", Tooltip =
                "The appearance of the light: sets Angular Diameter and Softness Cap. The sun's real disc is 0.53 " +
                "degrees wide; larger discs approximate haze and cloud.";
        }
        internal static class Technique
        {
            internal const string Label = "Technique", Tooltip =
                "The filter. Tents and filtered maps (ESM, VSM, EVSM, MSM) blur by a fixed number of shadow map " +
                "texels. PCSS and the others are sharp at contacts and widen with distance. Names in brackets are " +
                "engines whose rules and limits the filter follows.";
        }
        internal static class AngularDiameterDegrees
        {
            internal const string Label = "Angular Diameter", Tooltip =
                "Full angle of the light's disc in degrees, 0 to 30. The sun's is 0.53. A larger disc makes wider " +
                "penumbrae.";
            internal const float Min = 0.0f, Max = 30.0f;
        }
        internal static class BlockerSamples
        {
            internal const string Label = "Blocker Samples", Tooltip =
                "Texture fetches per pixel that search for shadow casters, 1 to 128. Too few miss thin casters. " +
                "PCSS (Poisson), PCSS (Godot), DPCF (Filament) and Single loop use the same number for their " +
                "filter.";
            internal const int Min = 1, Max = 128;
        }
        internal static class FilterSamples
        {
            internal const string Label = "Filter Samples", Tooltip =
                "Texture fetches per pixel that measure how much of the light is visible, 1 to 128. Too few make " +
                "penumbrae grainy.";
            internal const int Min = 1, Max = 128;
        }
        internal static class SoftnessCapMetres
        {
            internal const string Label = "Softness Cap", Tooltip =
                "Widest penumbra in metres, full width, 0 to 100. Wider ones are limited to this width.";
            internal const float Min = 0.0f, Max = 100.0f;
        }
        internal static class MinFilterTexels
        {
            internal const string Label = "Min Filter", Tooltip =
                "Smallest filter radius in texels of the shadow map, 0 to 8. Hides the map's texels at contacts; " +
                "large values leak light there.";
            internal const float Min = 0.0f, Max = 8.0f;
        }
        internal static class LightBleeding
        {
            internal const string Label = "Light Bleeding Reduction", Tooltip =
                "Visibility up to which all is dark, 0 to 0.95. Filtered maps let light through where casters " +
                "overlap; larger values hide it, and make penumbrae narrower and darker.";
            internal const float Min = 0.0f, Max = 0.95f;
        }
        internal static class MapBlurTexels
        {
            internal const string Label = "Map Blur", Tooltip =
                "Standard deviation of the blur of the filtered map in texels of the shadow map, 0 to 4. Penumbrae " +
                "are about four times as wide.";
            internal const float Min = 0.0f, Max = 4.0f;
        }
        internal static class MapFormat
        {
            internal const string Label = "Map Format", Tooltip =
                "Bits of each channel of the filtered map. 16 bits take half of the memory and bandwidth, and let " +
                "more light through or fade shadows at contacts. Where a device cannot draw 32 bits or filter them, " +
                "16 are used.";
        }
        internal static class Rays
        {
            internal const string Label = "Rays", Tooltip =
                "Rays per pixel from the receiver to the light's disc, 1 to 64. Too few make penumbrae grainy.";
            internal const int Min = 1, Max = 64;
        }
        internal static class SamplesPerRay
        {
            internal const string Label = "Samples Per Ray", Tooltip =
                "Texture fetches along each ray, 1 to 64. Too few miss casters that are thin.";
            internal const int Min = 1, Max = 64;
        }
        internal static class DiscRadiusMetres
        {
            internal const string Label = "Disc Radius", Tooltip =
                "Largest radius of the disc of samples in metres, 0 to 1, and with it of a penumbra. A wider disc " +
                "blurs narrow penumbrae, a narrower one cuts wide ones off.";
            internal const float Min = 0.0f, Max = 1.0f;
        }
        internal static class Mask
        {
            internal const string Label = "Mask", Tooltip =
                "Runs the full filter only where a coarse search finds an edge; elsewhere a pixel reads the shadow " +
                "map once.";
        }
        internal static class ConservativeMask
        {
            internal const string Label = "Conservative Mask", Tooltip =
                "Makes the mask from bounds of the shadow map's depths instead: it skips no pixel at which the " +
                "filter would find a penumbra. It skips more pixels than the other mask, and costs more itself. For " +
                "PCSS; not with OpenGL.";
        }
        internal static class HalfResolution
        {
            internal const string Label = "Half Resolution", Tooltip =
                "Filters a quarter of the pixels, every second one along both axes, and interpolates the others " +
                "without crossing edges. Where neighbours differ widely, each pixel is filtered.";
        }
        internal static class Denoise
        {
            internal const string Label = "Denoise", Tooltip =
                "Smooths the grain of the samples along surfaces, but not across edges.";
        }
        internal static class CascadeBlend
        {
            internal const string Label = "Cascade Blend", Tooltip =
                "Width of the border in which a cascade is dithered with the next, as a share of the cascade's " +
                "radius, 0 to 0.5. It hides the line between cascades; its noise needs temporal antialiasing, or " +
                "Denoise with a technique that takes samples. 0: none.";
            internal const float Min = 0.0f, Max = 0.5f;
        }
        internal static class ContactShadowMetres
        {
            internal const string Label = "Contact Shadows", Tooltip =
                "Length in metres of contact shadows, 0 to 2: a march towards the sun over the camera's depth " +
                "darkens what the shadow map's bias or texels lose. What the camera does not see casts none, and " +
                "beside things that stand free it darkens too much. 0: none.";
            internal const float Min = 0.0f, Max = 2.0f;
        }
        internal static class ContactShadowSteps
        {
            internal const string Label = "Contact Shadow Steps", Tooltip =
                "Texture fetches per pixel along the ray of contact shadows, 1 to 64. Too few miss thin casters.";
            internal const int Min = 1, Max = 64;
        }
        internal static class FarShadows
        {
            internal const string Label = "Far Shadows", Tooltip =
                "Shadows of mountains and hills beyond the shadow distance. Height Map: of a Terrain or a baked " +
                "height map, searched towards the sun in every frame. Horizon Angles: of two baked textures, with " +
                "two fetches per pixel; a low sun must be near one of the eight baked directions, every 45 degrees " +
                "from +Z. Both need a Far Shadow Ground component in the scene.";
        }
        internal static class Clouds
        {
            internal const string Label = "Cloud Shadows", Tooltip =
                "Shadows of a layer of procedural clouds, near and far. Transparent surfaces do not receive them.";
        }
        internal static class DebugView
        {
            internal const string Label = "Debug View", Tooltip =
                "Drawn over the image in the editor and in development builds: visibility, cascades, shadow map " +
                "texels, penumbra width or mask.";
        }
    }
}
