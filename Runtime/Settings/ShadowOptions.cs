using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// Everything that decides how a frame's shadow is computed. Lengths are metres, angles degrees, counts fetches.
    /// Presets fill it (ShadowPresets); the Volume overrides single values.
    /// </summary>
    [Serializable]
    public struct ShadowOptions : IEquatable<ShadowOptions>
    {
        [Tooltip(OptionTooltips.Technique)]
        public ShadowTechnique technique;

        /// <summary>Full angle of the light's disc, 0 to 30; the sun's is 0.53. Penumbrae widen with it.</summary>
        [Tooltip(OptionTooltips.AngularDiameter)]
        [Range(0.0f, 30.0f)]
        public float angularDiameterDegrees;

        /// <summary>Samples that look for blockers, 1 to 64. PCSS (Poisson) takes this many in both loops.</summary>
        [Tooltip(OptionTooltips.BlockerSamples)]
        [Range(1, 64)]
        public int blockerSamples;

        /// <summary>Samples of the filter, 1 to 64.</summary>
        [Tooltip(OptionTooltips.FilterSamples)]
        [Range(1, 64)]
        public int filterSamples;

        /// <summary>Widest penumbra, full width, 0 to 100: what is wider is cut short, and costs less to look for.</summary>
        [Tooltip(OptionTooltips.SoftnessCap)]
        [Range(0.0f, 100.0f)]
        public float softnessCapMetres;

        /// <summary>Smallest filter radius in shadow-map texels, 0 to 8: hides the texels of contacts.</summary>
        [Tooltip(OptionTooltips.MinFilter)]
        [Range(0.0f, 8.0f)]
        public float minFilterTexels;

        /// <summary>Full filter only where the mask finds a penumbra; one look at the shadow map elsewhere.</summary>
        [Tooltip(OptionTooltips.Mask)]
        public bool mask;

        /// <summary>Resolve a quarter of the pixels and fill in the rest along edges.</summary>
        [Tooltip(OptionTooltips.HalfResolution)]
        public bool halfResolution;

        /// <summary>Blur the noise of the samples away without crossing edges.</summary>
        [Tooltip(OptionTooltips.Denoise)]
        public bool denoise;

        /// <summary>
        /// These options with the light of others: its size and its widest penumbra, which no quality preset decides.
        /// </summary>
        internal ShadowOptions Under(float degrees, float capMetres)
        {
            ShadowOptions options = this;
            options.angularDiameterDegrees = degrees;
            options.softnessCapMetres = Mathf.Min(softnessCapMetres, capMetres);
            return options;
        }

        /// <summary>Drawn over the picture; the feature's and the Volume's to set, no preset's.</summary>
        [NonSerialized] public DebugView debugView;

        public bool Equals(ShadowOptions other) =>
            technique == other.technique && angularDiameterDegrees.Equals(other.angularDiameterDegrees) &&
            blockerSamples == other.blockerSamples && filterSamples == other.filterSamples &&
            softnessCapMetres.Equals(other.softnessCapMetres) && minFilterTexels.Equals(other.minFilterTexels) &&
            mask == other.mask && halfResolution == other.halfResolution && denoise == other.denoise &&
            debugView == other.debugView;

        public override bool Equals(object other) => other is ShadowOptions options && Equals(options);

        public override int GetHashCode() =>
            ((int)technique * 397) ^ (blockerSamples << 8) ^ (filterSamples << 16) ^
            angularDiameterDegrees.GetHashCode() ^ softnessCapMetres.GetHashCode();

        /// <summary>The same with every value within its range.</summary>
        public ShadowOptions Clamped()
        {
            ShadowOptions options = this;
            options.angularDiameterDegrees = Mathf.Clamp(FiniteOr(angularDiameterDegrees, 0.53f), 0.0f, 30.0f);
            options.blockerSamples = Mathf.Clamp(blockerSamples, 1, 64);
            options.filterSamples = Mathf.Clamp(filterSamples, 1, 64);
            options.softnessCapMetres = Mathf.Clamp(FiniteOr(softnessCapMetres, 100.0f), 0.0f, 100.0f);
            options.minFilterTexels = Mathf.Clamp(FiniteOr(minFilterTexels, 1.0f), 0.0f, 8.0f);
            return options;
        }

        /// <summary>The technique samples penumbrae, and there are some: their noise and their place matter.</summary>
        internal bool SamplesPenumbrae => technique.TakesSamples() && angularDiameterDegrees > 0.0f;

        /// <summary>
        /// As the filters are told. What no option changes is as the study measures it (SoftShadowParameters); HDRP's
        /// technique has HDRP's own limits.
        /// </summary>
        public SoftShadowParameters Parameters()
        {
            bool hdrp = technique == ShadowTechnique.PcssHdrp;
            SoftShadowParameters parameters = hdrp ? SoftShadowParameters.HdrpDefault : SoftShadowParameters.Default;
            parameters.AngularDiameterDegrees = angularDiameterDegrees;
            parameters.BlockerSamples = blockerSamples;
            parameters.FilterSamples = filterSamples;
            if (hdrp) return parameters;
            parameters.MaxPenumbraMetres = softnessCapMetres;
            parameters.MinFilterTexels = minFilterTexels;
            return parameters;
        }

        private static float FiniteOr(float value, float fallback) =>
            float.IsNaN(value) || float.IsInfinity(value) ? fallback : value;
    }
}
