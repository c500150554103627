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
            options => options.technique.Entry().widensWithDisc, volume => volume.angularDiameterDegrees);

        internal static readonly OptionField BlockerSamples = new OptionField(
            nameof(ShadowOptions.blockerSamples), OptionTable.BlockerSamples.Label, OptionTable.BlockerSamples.Tooltip,
            options => options.technique.Entry().Takes(nameof(ShadowOptions.blockerSamples)), volume => volume.blockerSamples);

        internal static readonly OptionField FilterSamples = new OptionField(
            nameof(ShadowOptions.filterSamples), OptionTable.FilterSamples.Label, OptionTable.FilterSamples.Tooltip,
            options => options.technique.Entry().Takes(nameof(ShadowOptions.filterSamples)), volume => volume.filterSamples);

        // A filter without a limit has a mask that is limited by the softness cap; PCSS (HDRP) has a cap of its own.
        internal static readonly OptionField SoftnessCap = new OptionField(
            nameof(ShadowOptions.softnessCapMetres), OptionTable.SoftnessCapMetres.Label,
            OptionTable.SoftnessCapMetres.Tooltip,
            options => options.technique.Entry().widensWithDisc && options.angularDiameterDegrees > 0.0f &&
                       (options.technique.Entry().Takes(nameof(ShadowOptions.softnessCapMetres)) ||
                        (options.SamplesPenumbrae && options.mask && !options.technique.Entry().limitsWidth)),
            volume => volume.softnessCapMetres);

        internal static readonly OptionField MinFilter = new OptionField(
            nameof(ShadowOptions.minFilterTexels), OptionTable.MinFilterTexels.Label,
            OptionTable.MinFilterTexels.Tooltip,
            options => options.technique.Entry().Takes(nameof(ShadowOptions.minFilterTexels)),
            null);

        internal static readonly OptionField LightBleeding = new OptionField(
            nameof(ShadowOptions.lightBleeding), OptionTable.LightBleeding.Label, OptionTable.LightBleeding.Tooltip,
            options => options.technique.Entry().Takes(nameof(ShadowOptions.lightBleeding)), volume => volume.lightBleeding);

        internal static readonly OptionField MapBlur = new OptionField(
            nameof(ShadowOptions.mapBlurTexels), OptionTable.MapBlurTexels.Label, OptionTable.MapBlurTexels.Tooltip,
            options => options.technique.Entry().Takes(nameof(ShadowOptions.mapBlurTexels)), volume => volume.mapBlurTexels);

        internal static readonly OptionField MapFormat = new OptionField(
            nameof(ShadowOptions.mapFormat), OptionTable.MapFormat.Label, OptionTable.MapFormat.Tooltip,
            options => options.HasMapFormats, volume => volume.mapFormat);

        internal static readonly OptionField Rays = new OptionField(
            nameof(ShadowOptions.rays), OptionTable.Rays.Label, OptionTable.Rays.Tooltip,
            options => options.technique.Entry().Takes(nameof(ShadowOptions.rays)), volume => volume.rays);

        internal static readonly OptionField SamplesPerRay = new OptionField(
            nameof(ShadowOptions.samplesPerRay), OptionTable.SamplesPerRay.Label, OptionTable.SamplesPerRay.Tooltip,
            options => options.technique.Entry().Takes(nameof(ShadowOptions.samplesPerRay)), volume => volume.samplesPerRay);

        internal static readonly OptionField DiscRadius = new OptionField(
            nameof(ShadowOptions.discRadiusMetres), OptionTable.DiscRadiusMetres.Label, OptionTable.DiscRadiusMetres.Tooltip,
            options => options.technique.Entry().Takes(nameof(ShadowOptions.discRadiusMetres)), volume => volume.discRadiusMetres);

        internal static readonly OptionField Mask = new OptionField(
            nameof(ShadowOptions.mask), OptionTable.Mask.Label, OptionTable.Mask.Tooltip,
            options => options.SamplesPenumbrae, volume => volume.mask);

        internal static readonly OptionField ConservativeMask = new OptionField(
            nameof(ShadowOptions.conservativeMask), OptionTable.ConservativeMask.Label,
            OptionTable.ConservativeMask.Tooltip,
            options => options.CanMaskConservatively, volume => volume.conservativeMask);

        internal static readonly OptionField HalfResolution = new OptionField(
            nameof(ShadowOptions.halfResolution), OptionTable.HalfResolution.Label, OptionTable.HalfResolution.Tooltip,
            options => options.CanHalveResolution, volume => volume.halfResolution);

        internal static readonly OptionField Denoise = new OptionField(
            nameof(ShadowOptions.denoise), OptionTable.Denoise.Label, OptionTable.Denoise.Tooltip,
            options => options.SamplesPenumbrae, volume => volume.denoise);

        /// <summary>The field is not part of any preset.</summary>
        internal static readonly OptionField CascadeBlend = new OptionField(
            nameof(ShadowOptions.cascadeBlend), OptionTable.CascadeBlend.Label, OptionTable.CascadeBlend.Tooltip,
            options => true, volume => volume.cascadeBlend);

        /// <summary>The field is not part of any preset.</summary>
        internal static readonly OptionField ContactShadows = new OptionField(
            nameof(ShadowOptions.contactShadowMetres), OptionTable.ContactShadowMetres.Label,
            OptionTable.ContactShadowMetres.Tooltip,
            options => true, volume => volume.contactShadowMetres);

        internal static readonly OptionField ContactShadowSteps = new OptionField(
            nameof(ShadowOptions.contactShadowSteps), OptionTable.ContactShadowSteps.Label,
            OptionTable.ContactShadowSteps.Tooltip,
            options => options.HasContactShadows, volume => volume.contactShadowSteps);

        /// <summary>The field is not part of any preset, nor of Volumes.</summary>
        internal static readonly OptionField FarShadows = new OptionField(
            nameof(ShadowOptions.farShadows), OptionTable.FarShadows.Label, OptionTable.FarShadows.Tooltip,
            options => true, null);

        internal static readonly OptionField Clouds = new OptionField(
            nameof(ShadowOptions.clouds), OptionTable.Clouds.Label, OptionTable.Clouds.Tooltip, options => true, null);

        /// <summary>The field is not part of any preset; the feature sets it unless a Volume overrides it.</summary>
        internal static readonly OptionField DebugView = new OptionField(
            nameof(ShadowOptions.debugView), OptionTable.DebugView.Label, OptionTable.DebugView.Tooltip,
            options => true, volume => volume.debugView);

        internal static readonly OptionField[] All =
        {
            Technique, AngularDiameter, BlockerSamples, FilterSamples, Rays, SamplesPerRay, DiscRadius,
            SoftnessCap, MinFilter, LightBleeding, MapBlur, MapFormat, Mask, ConservativeMask, HalfResolution, Denoise,
        };
    }
}
