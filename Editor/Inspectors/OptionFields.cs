using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>The options in the order of the inspectors of the feature and of the Volume.</summary>
    internal static class OptionFields
    {
        internal static readonly GUIContent Preset =
            new GUIContent(OptionTable.Quality.Label, OptionTable.Quality.Tooltip);

        internal static readonly OptionField Technique = new OptionField(
            nameof(ShadowOptions.technique), OptionTable.Technique.Label, OptionTable.Technique.Tooltip,
            options => true, volume => volume.technique);

        internal static readonly OptionField AngularDiameter = new OptionField(
            nameof(ShadowOptions.angularDiameterDegrees), OptionTable.AngularDiameterDegrees.Label,
            OptionTable.AngularDiameterDegrees.Tooltip,
            options => options.technique.TakesSamples(), volume => volume.angularDiameterDegrees);

        internal static readonly OptionField BlockerSamples = new OptionField(
            nameof(ShadowOptions.blockerSamples), OptionTable.BlockerSamples.Label, OptionTable.BlockerSamples.Tooltip,
            options => options.technique.Takes(nameof(ShadowOptions.blockerSamples)), volume => volume.blockerSamples);

        internal static readonly OptionField FilterSamples = new OptionField(
            nameof(ShadowOptions.filterSamples), OptionTable.FilterSamples.Label, OptionTable.FilterSamples.Tooltip,
            options => options.technique.Takes(nameof(ShadowOptions.filterSamples)), volume => volume.filterSamples);

        // PCSS (Poisson) has no softness cap, but its mask is limited by it; PCSS (HDRP) has a cap of its own.
        internal static readonly OptionField SoftnessCap = new OptionField(
            nameof(ShadowOptions.softnessCapMetres), OptionTable.SoftnessCapMetres.Label,
            OptionTable.SoftnessCapMetres.Tooltip,
            options => options.SamplesPenumbrae &&
                       (options.technique.Takes(nameof(ShadowOptions.softnessCapMetres)) ||
                        (options.technique == ShadowTechnique.PcssPoisson && options.mask)),
            volume => volume.softnessCapMetres);

        internal static readonly OptionField MinFilter = new OptionField(
            nameof(ShadowOptions.minFilterTexels), OptionTable.MinFilterTexels.Label,
            OptionTable.MinFilterTexels.Tooltip,
            options => options.technique.Takes(nameof(ShadowOptions.minFilterTexels)),
            null);

        internal static readonly OptionField Mask = new OptionField(
            nameof(ShadowOptions.mask), OptionTable.Mask.Label, OptionTable.Mask.Tooltip,
            options => options.SamplesPenumbrae, volume => volume.mask);

        internal static readonly OptionField ConservativeMask = new OptionField(
            nameof(ShadowOptions.conservativeMask), OptionTable.ConservativeMask.Label,
            OptionTable.ConservativeMask.Tooltip,
            options => options.CanMaskConservatively, volume => volume.conservativeMask);

        internal static readonly OptionField HalfResolution = new OptionField(
            nameof(ShadowOptions.halfResolution), OptionTable.HalfResolution.Label, OptionTable.HalfResolution.Tooltip,
            options => true, volume => volume.halfResolution);

        internal static readonly OptionField Denoise = new OptionField(
            nameof(ShadowOptions.denoise), OptionTable.Denoise.Label, OptionTable.Denoise.Tooltip,
            options => options.SamplesPenumbrae, volume => volume.denoise);

        /// <summary>Not part of any preset.</summary>
        internal static readonly OptionField CascadeBlend = new OptionField(
            nameof(ShadowOptions.cascadeBlend), OptionTable.CascadeBlend.Label, OptionTable.CascadeBlend.Tooltip,
            options => true, volume => volume.cascadeBlend);

        /// <summary>Not part of any preset; set by the feature unless a Volume overrides it.</summary>
        internal static readonly OptionField DebugView = new OptionField(
            nameof(ShadowOptions.debugView), OptionTable.DebugView.Label, OptionTable.DebugView.Tooltip,
            options => true, volume => volume.debugView);

        internal static readonly OptionField[] All =
        {
            Technique, AngularDiameter, BlockerSamples, FilterSamples, SoftnessCap, MinFilter, Mask, ConservativeMask,
            HalfResolution, Denoise,
        };
    }
}
