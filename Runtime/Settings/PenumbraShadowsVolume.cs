using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// Overrides the feature's options by place and priority. What is not overridden stays as the feature has it; a
    /// preset here comes before the single values beside it.
    /// </summary>
    [Serializable]
#if UNITY_6000_0_OR_NEWER
    [VolumeComponentMenu("Lighting/Penumbra Soft Shadows")]
    [SupportedOnRenderPipeline(typeof(UniversalRenderPipelineAsset))]
#else
    [VolumeComponentMenuForRenderPipeline("Lighting/Penumbra Soft Shadows", typeof(UniversalRenderPipeline))]
#endif
    public sealed class PenumbraShadowsVolume : VolumeComponent
    {
        public QualityPresetParameter preset = new QualityPresetParameter(QualityPreset.Medium);
        public ClampedFloatParameter angularDiameterDegrees =
            new ClampedFloatParameter(AngularDiameter.SunDegrees, 0.0f, 30.0f);
        public ShadowTechniqueParameter technique = new ShadowTechniqueParameter(ShadowTechnique.Pcss);
        public ClampedIntParameter blockerSamples = new ClampedIntParameter(12, 1, 64);
        public ClampedIntParameter filterSamples = new ClampedIntParameter(8, 1, 64);
        public ClampedFloatParameter softnessCapMetres = new ClampedFloatParameter(100.0f, 0.0f, 100.0f);
        public BoolParameter mask = new BoolParameter(true);
        public BoolParameter halfResolution = new BoolParameter(false);
        public BoolParameter denoise = new BoolParameter(true);
        public DebugViewParameter debugView = new DebugViewParameter(DebugView.None);

        /// <summary>`options` with what this Volume overrides.</summary>
        public ShadowOptions Over(ShadowOptions options)
        {
            if (preset.overrideState && preset.value != QualityPreset.Custom)
            {
                ShadowOptions before = options;
                options = ShadowPresets.Options(preset.value);
                options.angularDiameterDegrees = before.angularDiameterDegrees;
                options.debugView = before.debugView;
            }
            if (angularDiameterDegrees.overrideState) options.angularDiameterDegrees = angularDiameterDegrees.value;
            if (technique.overrideState) options.technique = technique.value;
            if (blockerSamples.overrideState) options.blockerSamples = blockerSamples.value;
            if (filterSamples.overrideState) options.filterSamples = filterSamples.value;
            if (softnessCapMetres.overrideState) options.softnessCapMetres = softnessCapMetres.value;
            if (mask.overrideState) options.mask = mask.value;
            if (halfResolution.overrideState) options.halfResolution = halfResolution.value;
            if (denoise.overrideState) options.denoise = denoise.value;
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
    public sealed class DebugViewParameter : VolumeParameter<DebugView>
    {
        public DebugViewParameter(DebugView value, bool overrideState = false) : base(value, overrideState) { }
    }
}
