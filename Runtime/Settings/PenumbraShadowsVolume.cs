using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// Overrides the feature's options by place and priority. Options that it does not override keep the feature's
    /// value. A preset is applied first, then the single options.
    /// </summary>
    [Serializable]
    [PackagePage("installation.md")]
#if UNITY_6000_0_OR_NEWER
    [VolumeComponentMenu("Lighting/" + PenumbraShadows.Title)]
    [SupportedOnRenderPipeline(typeof(UniversalRenderPipelineAsset))]
#else
    [VolumeComponentMenuForRenderPipeline("Lighting/" + PenumbraShadows.Title, typeof(UniversalRenderPipeline))]
#endif
    public sealed class PenumbraShadowsVolume : VolumeComponent
    {
        [Tooltip(OptionTable.Quality.Tooltip)]
        public QualityPresetParameter preset = new QualityPresetParameter(QualityPreset.Medium);

        [Tooltip(OptionTable.AngularDiameterDegrees.Tooltip)]
        public ClampedFloatParameter angularDiameterDegrees =
            new ClampedFloatParameter(AngularDiameter.SunDegrees, OptionTable.AngularDiameterDegrees.Min,
                                      OptionTable.AngularDiameterDegrees.Max);

        [Tooltip(OptionTable.Technique.Tooltip)]
        public ShadowTechniqueParameter technique =
            new ShadowTechniqueParameter(ShadowPresets.Options(QualityPreset.Medium).technique);

        [Tooltip(OptionTable.BlockerSamples.Tooltip)]
        public ClampedIntParameter blockerSamples = new ClampedIntParameter(12, OptionTable.BlockerSamples.Min,
                                                                            OptionTable.BlockerSamples.Max);

        [Tooltip(OptionTable.FilterSamples.Tooltip)]
        public ClampedIntParameter filterSamples = new ClampedIntParameter(8, OptionTable.FilterSamples.Min,
                                                                           OptionTable.FilterSamples.Max);

        [Tooltip(OptionTable.SoftnessCapMetres.Tooltip)]
        public ClampedFloatParameter softnessCapMetres = new ClampedFloatParameter(100.0f,
                                                                                   OptionTable.SoftnessCapMetres.Min,
                                                                                   OptionTable.SoftnessCapMetres.Max);

        [Tooltip(OptionTable.LightBleeding.Tooltip)]
        public ClampedFloatParameter lightBleeding = new ClampedFloatParameter(0.2f, OptionTable.LightBleeding.Min,
                                                                               OptionTable.LightBleeding.Max);

        [Tooltip(OptionTable.MapBlurTexels.Tooltip)]
        public ClampedFloatParameter mapBlurTexels = new ClampedFloatParameter(1.5f, OptionTable.MapBlurTexels.Min,
                                                                               OptionTable.MapBlurTexels.Max);

        [Tooltip(OptionTable.MapFormat.Tooltip)]
        public MapFormatParameter mapFormat = new MapFormatParameter(MapFormat.Bits32);

        [Tooltip(OptionTable.Rays.Tooltip)]
        public ClampedIntParameter rays = new ClampedIntParameter(7, OptionTable.Rays.Min, OptionTable.Rays.Max);

        [Tooltip(OptionTable.SamplesPerRay.Tooltip)]
        public ClampedIntParameter samplesPerRay = new ClampedIntParameter(8, OptionTable.SamplesPerRay.Min,
                                                                           OptionTable.SamplesPerRay.Max);

        [Tooltip(OptionTable.DiscRadiusMetres.Tooltip)]
        public ClampedFloatParameter discRadiusMetres = new ClampedFloatParameter(0.05f, OptionTable.DiscRadiusMetres.Min,
                                                                                  OptionTable.DiscRadiusMetres.Max);

        [Tooltip(OptionTable.Mask.Tooltip)]
        public BoolParameter mask = new BoolParameter(true);

        [Tooltip(OptionTable.ConservativeMask.Tooltip)]
        public BoolParameter conservativeMask = new BoolParameter(true);

        [Tooltip(OptionTable.HalfResolution.Tooltip)]
        public BoolParameter halfResolution = new BoolParameter(false);

        [Tooltip(OptionTable.Denoise.Tooltip)]
        public BoolParameter denoise = new BoolParameter(true);

        [Tooltip(OptionTable.CascadeBlend.Tooltip)]
        public ClampedFloatParameter cascadeBlend = new ClampedFloatParameter(0.1f, OptionTable.CascadeBlend.Min,
                                                                              OptionTable.CascadeBlend.Max);

        [Tooltip(OptionTable.ContactShadowMetres.Tooltip)]
        public ClampedFloatParameter contactShadowMetres =
            new ClampedFloatParameter(ScreenTraceParameters.Default.traceLengthMetres,
                                      OptionTable.ContactShadowMetres.Min, OptionTable.ContactShadowMetres.Max);

        [Tooltip(OptionTable.ContactShadowSteps.Tooltip)]
        public ClampedIntParameter contactShadowSteps =
            new ClampedIntParameter(ScreenTraceParameters.Default.traceSteps, OptionTable.ContactShadowSteps.Min,
                                    OptionTable.ContactShadowSteps.Max);

        [Tooltip(OptionTable.DebugView.Tooltip)]
        public DebugViewParameter debugView = new DebugViewParameter(DebugView.None);

        /// <summary>
        /// Overrides the angular diameter and the softness cap with those of a look. Throws
        /// ArgumentOutOfRangeException for Custom, which has none.
        /// </summary>
        public void Override(ShadowLook look)
        {
            LookValues values = ShadowLooks.Values(look);
            angularDiameterDegrees.overrideState = softnessCapMetres.overrideState = true;
            angularDiameterDegrees.value = values.angularDiameterDegrees;
            softnessCapMetres.value = values.softnessCapMetres;
        }

        /// <summary>`options` with this Volume's overrides applied.</summary>
        public ShadowOptions Over(ShadowOptions options)
        {
            if (preset.overrideState && preset.value != QualityPreset.Custom)
            {
                ShadowOptions before = options;
                options = ShadowPresets.Options(preset.value)
                    .Under(before.angularDiameterDegrees, before.softnessCapMetres);
                options.cascadeBlend = before.cascadeBlend;
                options.contactShadowMetres = before.contactShadowMetres;
                options.contactShadowSteps = before.contactShadowSteps;
                options.farShadows = before.farShadows;
                options.clouds = before.clouds;
                options.debugView = before.debugView;
            }
            if (angularDiameterDegrees.overrideState) options.angularDiameterDegrees = angularDiameterDegrees.value;
            if (technique.overrideState) options.technique = technique.value;
            if (blockerSamples.overrideState) options.blockerSamples = blockerSamples.value;
            if (filterSamples.overrideState) options.filterSamples = filterSamples.value;
            if (softnessCapMetres.overrideState) options.softnessCapMetres = softnessCapMetres.value;
            if (lightBleeding.overrideState) options.lightBleeding = lightBleeding.value;
            if (mapBlurTexels.overrideState) options.mapBlurTexels = mapBlurTexels.value;
            if (mapFormat.overrideState) options.mapFormat = mapFormat.value;
            if (rays.overrideState) options.rays = rays.value;
            if (samplesPerRay.overrideState) options.samplesPerRay = samplesPerRay.value;
            if (discRadiusMetres.overrideState) options.discRadiusMetres = discRadiusMetres.value;
            if (mask.overrideState) options.mask = mask.value;
            if (conservativeMask.overrideState) options.conservativeMask = conservativeMask.value;
            if (halfResolution.overrideState) options.halfResolution = halfResolution.value;
            if (denoise.overrideState) options.denoise = denoise.value;
            if (cascadeBlend.overrideState) options.cascadeBlend = cascadeBlend.value;
            if (contactShadowMetres.overrideState) options.contactShadowMetres = contactShadowMetres.value;
            if (contactShadowSteps.overrideState) options.contactShadowSteps = contactShadowSteps.value;
            if (debugView.overrideState) options.debugView = debugView.value;
            return options.Clamped();
        }
    }

    [Serializable]
    public sealed class QualityPresetParameter : VolumeParameter<QualityPreset>
    {
        public QualityPresetParameter(QualityPreset value, bool overrideState = false) : base(value, overrideState) { }
    }

    [Serializable]
    public sealed class ShadowTechniqueParameter : VolumeParameter<ShadowTechnique>
    {
        public ShadowTechniqueParameter(ShadowTechnique value, bool overrideState = false)
            : base(value, overrideState) { }
    }

    [Serializable]
    public sealed class MapFormatParameter : VolumeParameter<MapFormat>
    {
        public MapFormatParameter(MapFormat value, bool overrideState = false) : base(value, overrideState) { }
    }

    [Serializable]
    public sealed class DebugViewParameter : VolumeParameter<DebugView>
    {
        public DebugViewParameter(DebugView value, bool overrideState = false) : base(value, overrideState) { }
    }
}
