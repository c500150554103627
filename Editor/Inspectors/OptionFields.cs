using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>The options in the order in which the feature's inspector and the Volume's show them.</summary>
    internal static class OptionFields
    {
        internal static readonly GUIContent Preset =
            new GUIContent("Quality", "What a pixel may cost: all options at once. Custom has every option set by hand.");

        internal static readonly OptionField Technique = new OptionField(
            nameof(ShadowOptions.technique), "Technique",
            "The filter. Tents blur by texels and do not harden at contacts; PCSS does. PCSS HDRP keeps HDRP's rules " +
            "and limits.",
            options => true, volume => volume.technique);

        internal static readonly OptionField AngularDiameter = new OptionField(
            nameof(ShadowOptions.angularDiameterDegrees), "Angular Diameter",
            "Full angle of the light's disc in degrees, 0 to 30; the sun's is 0.53. Penumbrae widen with it.",
            options => options.technique.TakesSamples(), volume => volume.angularDiameterDegrees);

        internal static readonly OptionField BlockerSamples = new OptionField(
            nameof(ShadowOptions.blockerSamples), "Blocker Samples",
            "Fetches that look for what casts, 1 to 64. Too few miss thin casters. PCSS Poisson filters with as many.",
            options => options.technique.TakesSamples(), volume => volume.blockerSamples);

        internal static readonly OptionField FilterSamples = new OptionField(
            nameof(ShadowOptions.filterSamples), "Filter Samples",
            "Fetches that measure how much of the light is seen, 1 to 64. Too few are grainy.",
            options => options.technique == ShadowTechnique.Pcss || options.technique == ShadowTechnique.PcssHdrp,
            volume => volume.filterSamples);

        // Classic PCSS has no cap, but its mask looks no farther; HDRP's rules have a cap of their own.
        internal static readonly OptionField SoftnessCap = new OptionField(
            nameof(ShadowOptions.softnessCapMetres), "Softness Cap",
            "Widest penumbra in metres, full width, 0 to 100. What is wider is cut short, and the search stays small.",
            options => options.SamplesPenumbrae &&
                       (options.technique == ShadowTechnique.Pcss ||
                        (options.technique == ShadowTechnique.PcssPoisson && options.mask)),
            volume => volume.softnessCapMetres);

        internal static readonly OptionField MinFilter = new OptionField(
            nameof(ShadowOptions.minFilterTexels), "Min Filter",
            "Smallest filter radius in texels of the shadow map, 0 to 8. Hides the texels of contacts, and leaks light " +
            "there if it is large.",
            options => options.technique == ShadowTechnique.Pcss || options.technique == ShadowTechnique.PcssPoisson,
            null);

        internal static readonly OptionField Mask = new OptionField(
            nameof(ShadowOptions.mask), "Mask",
            "The full filter only where a coarse look at the edges finds a penumbra; one fetch a pixel elsewhere.",
            options => options.SamplesPenumbrae, volume => volume.mask);

        internal static readonly OptionField HalfResolution = new OptionField(
            nameof(ShadowOptions.halfResolution), "Half Resolution",
            "Every second pixel along both axes, a quarter of all; the rest is filled in along edges.",
            options => true, volume => volume.halfResolution);

        internal static readonly OptionField Denoise = new OptionField(
            nameof(ShadowOptions.denoise), "Denoise",
            "Smooths the samples' noise along surfaces, not across their edges.",
            options => options.SamplesPenumbrae, volume => volume.denoise);

        /// <summary>Beside the options: of no preset, and the feature's own where no Volume overrides it.</summary>
        internal static readonly OptionField DebugView = new OptionField(
            nameof(ShadowOptions.debugView), "Debug View",
            "Drawn over the picture in the editor and in development builds: visibility, cascades, the shadow map's " +
            "texels, the width of penumbrae, the mask.",
            options => true, volume => volume.debugView);

        internal static readonly OptionField[] All =
        {
            Technique, AngularDiameter, BlockerSamples, FilterSamples, SoftnessCap, MinFilter, Mask, HalfResolution,
            Denoise,
        };
    }
}
