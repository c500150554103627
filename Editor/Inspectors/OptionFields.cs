using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>The options in the order in which the feature's inspector and the Volume's show them.</summary>
    internal static class OptionFields
    {
        internal static readonly GUIContent Preset =
            new GUIContent("Quality", OptionTooltips.Quality);

        internal static readonly OptionField Technique = new OptionField(
            nameof(ShadowOptions.technique), "Technique", OptionTooltips.Technique,
            options => true, volume => volume.technique);

        internal static readonly OptionField AngularDiameter = new OptionField(
            nameof(ShadowOptions.angularDiameterDegrees), "Angular Diameter", OptionTooltips.AngularDiameter,
            options => options.technique.TakesSamples(), volume => volume.angularDiameterDegrees);

        internal static readonly OptionField BlockerSamples = new OptionField(
            nameof(ShadowOptions.blockerSamples), "Blocker Samples", OptionTooltips.BlockerSamples,
            options => options.technique.TakesSamples(), volume => volume.blockerSamples);

        internal static readonly OptionField FilterSamples = new OptionField(
            nameof(ShadowOptions.filterSamples), "Filter Samples", OptionTooltips.FilterSamples,
            options => options.technique == ShadowTechnique.Pcss || options.technique == ShadowTechnique.PcssHdrp,
            volume => volume.filterSamples);

        // PCSS (Poisson) has no cap, but its mask looks no farther; HDRP's rules have a cap of their own.
        internal static readonly OptionField SoftnessCap = new OptionField(
            nameof(ShadowOptions.softnessCapMetres), "Softness Cap", OptionTooltips.SoftnessCap,
            options => options.SamplesPenumbrae &&
                       (options.technique == ShadowTechnique.Pcss ||
                        (options.technique == ShadowTechnique.PcssPoisson && options.mask)),
            volume => volume.softnessCapMetres);

        internal static readonly OptionField MinFilter = new OptionField(
            nameof(ShadowOptions.minFilterTexels), "Min Filter", OptionTooltips.MinFilter,
            options => options.technique == ShadowTechnique.Pcss || options.technique == ShadowTechnique.PcssPoisson,
            null);

        internal static readonly OptionField Mask = new OptionField(
            nameof(ShadowOptions.mask), "Mask", OptionTooltips.Mask,
            options => options.SamplesPenumbrae, volume => volume.mask);

        internal static readonly OptionField HalfResolution = new OptionField(
            nameof(ShadowOptions.halfResolution), "Half Resolution", OptionTooltips.HalfResolution,
            options => true, volume => volume.halfResolution);

        internal static readonly OptionField Denoise = new OptionField(
            nameof(ShadowOptions.denoise), "Denoise", OptionTooltips.Denoise,
            options => options.SamplesPenumbrae, volume => volume.denoise);

        /// <summary>Beside the options: of no preset, and the feature's own where no Volume overrides it.</summary>
        internal static readonly OptionField DebugView = new OptionField(
            nameof(ShadowOptions.debugView), "Debug View", OptionTooltips.DebugView,
            options => true, volume => volume.debugView);

        internal static readonly OptionField[] All =
        {
            Technique, AngularDiameter, BlockerSamples, FilterSamples, SoftnessCap, MinFilter, Mask, HalfResolution,
            Denoise,
        };
    }
}
