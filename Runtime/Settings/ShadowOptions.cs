using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// All options of how a frame's shadow is computed. Lengths are metres, angles degrees, counts texture fetches.
    /// Presets fill them (ShadowPresets); the Volume overrides single values.
    /// </summary>
    [Serializable]
    public struct ShadowOptions : IEquatable<ShadowOptions>
    {
        [Tooltip(OptionTable.Technique.Tooltip)]
        public ShadowTechnique technique;

        /// <summary>Full angle of the light's disc, 0 to 30; the sun's is 0.53. Penumbrae widen with it.</summary>
        [Tooltip(OptionTable.AngularDiameterDegrees.Tooltip)]
        [Range(OptionTable.AngularDiameterDegrees.Min, OptionTable.AngularDiameterDegrees.Max)]
        public float angularDiameterDegrees;

        /// <summary>
        /// Samples of the blocker search, 1 to 128. PCSS (Poisson) and PCSS (Godot) use this many in both loops, DPCF
        /// (Filament) and Single loop the same ones for both.
        /// </summary>
        [Tooltip(OptionTable.BlockerSamples.Tooltip)]
        [Range(OptionTable.BlockerSamples.Min, OptionTable.BlockerSamples.Max)]
        public int blockerSamples;

        /// <summary>Samples of the filter, 1 to 128.</summary>
        [Tooltip(OptionTable.FilterSamples.Tooltip)]
        [Range(OptionTable.FilterSamples.Min, OptionTable.FilterSamples.Max)]
        public int filterSamples;

        /// <summary>
        /// Widest penumbra, full width, 0 to 100: wider ones are limited to it, which also makes the search cheaper.
        /// </summary>
        [Tooltip(OptionTable.SoftnessCapMetres.Tooltip)]
        [Range(OptionTable.SoftnessCapMetres.Min, OptionTable.SoftnessCapMetres.Max)]
        public float softnessCapMetres;

        /// <summary>
        /// Smallest filter radius in shadow-map texels, 0 to 8. It hides the shadow map's texels at contacts.
        /// </summary>
        [Tooltip(OptionTable.MinFilterTexels.Tooltip)]
        [Range(OptionTable.MinFilterTexels.Min, OptionTable.MinFilterTexels.Max)]
        public float minFilterTexels;

        /// <summary>
        /// Visibility up to which all is dark, 0 to 0.95. It hides light that filtered maps let through.
        /// </summary>
        [Tooltip(OptionTable.LightBleeding.Tooltip)]
        [Range(OptionTable.LightBleeding.Min, OptionTable.LightBleeding.Max)]
        public float lightBleeding;

        /// <summary>Standard deviation of the blur of filtered maps, in shadow-map texels, 0 to 4.</summary>
        [Tooltip(OptionTable.MapBlurTexels.Tooltip)]
        [Range(OptionTable.MapBlurTexels.Min, OptionTable.MapBlurTexels.Max)]
        public float mapBlurTexels;

        /// <summary>Format of filtered maps, where the technique has both.</summary>
        [Tooltip(OptionTable.MapFormat.Tooltip)]
        public MapFormat mapFormat;

        /// <summary>Rays of SMRT to the light's disc, 1 to 64.</summary>
        [Tooltip(OptionTable.Rays.Tooltip)]
        [Range(OptionTable.Rays.Min, OptionTable.Rays.Max)]
        public int rays;

        /// <summary>Samples along each ray of SMRT, 1 to 64.</summary>
        [Tooltip(OptionTable.SamplesPerRay.Tooltip)]
        [Range(OptionTable.SamplesPerRay.Min, OptionTable.SamplesPerRay.Max)]
        public int samplesPerRay;

        /// <summary>Largest radius of the disc of the single loop, 0 to 1.</summary>
        [Tooltip(OptionTable.DiscRadiusMetres.Tooltip)]
        [Range(OptionTable.DiscRadiusMetres.Min, OptionTable.DiscRadiusMetres.Max)]
        public float discRadiusMetres;

        /// <summary>
        /// Whether the full filter runs only where the mask finds a penumbra, with a single shadow map test elsewhere.
        /// </summary>
        [Tooltip(OptionTable.Mask.Tooltip)]
        public bool mask;

        /// <summary>
        /// Whether the mask is made from bounds of the shadow map's depths and misses no penumbra; for PCSS.
        /// </summary>
        [Tooltip(OptionTable.ConservativeMask.Tooltip)]
        public bool conservativeMask;

        /// <summary>Whether a quarter of the pixels is filtered and the rest is reconstructed along edges.</summary>
        [Tooltip(OptionTable.HalfResolution.Tooltip)]
        public bool halfResolution;

        /// <summary>Whether the noise of the samples is blurred without crossing edges.</summary>
        [Tooltip(OptionTable.Denoise.Tooltip)]
        public bool denoise;

        /// <summary>
        /// These options with the given angular diameter and at most the given softness cap: quality presets set
        /// neither.
        /// </summary>
        internal ShadowOptions Under(float degrees, float capMetres)
        {
            ShadowOptions options = this;
            options.angularDiameterDegrees = degrees;
            options.softnessCapMetres = Mathf.Min(softnessCapMetres, capMetres);
            return options;
        }

        /// <summary>
        /// Border in which a cascade is dithered with the next, a share of its split sphere's radius, 0 to 0.5; set by
        /// the feature and the Volume, by no preset.
        /// </summary>
        [Tooltip(OptionTable.CascadeBlend.Tooltip)]
        [Range(OptionTable.CascadeBlend.Min, OptionTable.CascadeBlend.Max)]
        [NonSerialized] public float cascadeBlend;

        /// <summary>
        /// Length of the rays of contact shadows, 0 to 2; at 0 there are none. Set by the feature and the Volume, by no
        /// preset.
        /// </summary>
        [Tooltip(OptionTable.ContactShadowMetres.Tooltip)]
        [Range(OptionTable.ContactShadowMetres.Min, OptionTable.ContactShadowMetres.Max)]
        [NonSerialized] public float contactShadowMetres;

        /// <summary>Samples along each ray of contact shadows, 1 to 64; set with their length.</summary>
        [Tooltip(OptionTable.ContactShadowSteps.Tooltip)]
        [Range(OptionTable.ContactShadowSteps.Min, OptionTable.ContactShadowSteps.Max)]
        [NonSerialized] public int contactShadowSteps;

        /// <summary>Shadows of the ground beyond the cascades; set by the feature, by no preset.</summary>
        [NonSerialized] public FarShadowMode farShadows;

        /// <summary>Shadows of a layer of clouds, near and far; set by the feature, by no preset.</summary>
        [NonSerialized] public bool clouds;

        /// <summary>
        /// The debug view that is drawn over the image; set by the feature and the Volume, by no preset.
        /// </summary>
        [NonSerialized] public DebugView debugView;

        /// <summary>
        /// Whether a pass averages the visibility over frames; set by the feature (Noise), by no preset.
        /// </summary>
        [NonSerialized] public bool accumulates;

        public bool Equals(ShadowOptions other) =>
            technique == other.technique && angularDiameterDegrees.Equals(other.angularDiameterDegrees) &&
            blockerSamples == other.blockerSamples && filterSamples == other.filterSamples &&
            softnessCapMetres.Equals(other.softnessCapMetres) && minFilterTexels.Equals(other.minFilterTexels) &&
            lightBleeding.Equals(other.lightBleeding) && mapBlurTexels.Equals(other.mapBlurTexels) &&
            mapFormat == other.mapFormat && rays == other.rays && samplesPerRay == other.samplesPerRay &&
            discRadiusMetres.Equals(other.discRadiusMetres) && mask == other.mask &&
            conservativeMask == other.conservativeMask && halfResolution == other.halfResolution && denoise == other.denoise &&
            cascadeBlend.Equals(other.cascadeBlend) && contactShadowMetres.Equals(other.contactShadowMetres) &&
            contactShadowSteps == other.contactShadowSteps && farShadows == other.farShadows &&
            clouds == other.clouds && debugView == other.debugView && accumulates == other.accumulates;

        public override bool Equals(object other) => other is ShadowOptions options && Equals(options);

        public override int GetHashCode() =>
            ((int)technique * 397) ^ (blockerSamples << 8) ^ (filterSamples << 16) ^
            angularDiameterDegrees.GetHashCode() ^ softnessCapMetres.GetHashCode();

        /// <summary>These options with every value clamped to its range.</summary>
        public ShadowOptions Clamped()
        {
            ShadowOptions options = this;
            options.angularDiameterDegrees = Mathf.Clamp(FiniteOr(angularDiameterDegrees, 0.53f),
                                                                  OptionTable.AngularDiameterDegrees.Min,
                                                         OptionTable.AngularDiameterDegrees.Max);
            options.blockerSamples = Mathf.Clamp(blockerSamples, OptionTable.BlockerSamples.Min,
                                                 OptionTable.BlockerSamples.Max);
            options.filterSamples = Mathf.Clamp(filterSamples, OptionTable.FilterSamples.Min,
                                                OptionTable.FilterSamples.Max);
            options.softnessCapMetres = Mathf.Clamp(FiniteOr(softnessCapMetres, 100.0f),
                                                             OptionTable.SoftnessCapMetres.Min,
                                                    OptionTable.SoftnessCapMetres.Max);
            options.minFilterTexels = Mathf.Clamp(FiniteOr(minFilterTexels, 1.0f), OptionTable.MinFilterTexels.Min,
                                                  OptionTable.MinFilterTexels.Max);
            options.lightBleeding = Mathf.Clamp(FiniteOr(lightBleeding, 0.0f), OptionTable.LightBleeding.Min,
                                                OptionTable.LightBleeding.Max);
            options.mapBlurTexels = Mathf.Clamp(FiniteOr(mapBlurTexels, 0.0f), OptionTable.MapBlurTexels.Min,
                                                OptionTable.MapBlurTexels.Max);
            options.rays = Mathf.Clamp(rays, OptionTable.Rays.Min, OptionTable.Rays.Max);
            options.samplesPerRay = Mathf.Clamp(samplesPerRay, OptionTable.SamplesPerRay.Min,
                                                OptionTable.SamplesPerRay.Max);
            options.discRadiusMetres = Mathf.Clamp(FiniteOr(discRadiusMetres, 0.0f), OptionTable.DiscRadiusMetres.Min,
                                                   OptionTable.DiscRadiusMetres.Max);
            options.cascadeBlend = Mathf.Clamp(FiniteOr(cascadeBlend, 0.0f), OptionTable.CascadeBlend.Min,
                                               OptionTable.CascadeBlend.Max);
            options.contactShadowMetres = Mathf.Clamp(FiniteOr(contactShadowMetres, 0.0f),
                                                      OptionTable.ContactShadowMetres.Min,
                                                      OptionTable.ContactShadowMetres.Max);
            options.contactShadowSteps = Mathf.Clamp(contactShadowSteps, OptionTable.ContactShadowSteps.Min,
                                                     OptionTable.ContactShadowSteps.Max);
            return options;
        }

        /// <summary>
        /// Whether a pass hands the cascades over to what is beyond them, so that nothing fades there.
        /// </summary>
        internal bool DrawsBeyondCascades => farShadows != FarShadowMode.Off || clouds;

        /// <summary>
        /// Whether the technique is a filter that samples penumbrae of non-zero width, so that the penumbra mask and
        /// the denoiser matter.
        /// </summary>
        internal bool SamplesPenumbrae => Entry.takesSamples && angularDiameterDegrees > 0.0f;

        /// <summary>
        /// Whether there is a mask; for a filter without samples it would cost as much as the filter.
        /// </summary>
        internal bool HasMask => mask && SamplesPenumbrae;

        /// <summary>
        /// Whether the conservative mask can be used: it decides by the cones of PCSS's filter, of no other's.
        /// </summary>
        internal bool CanMaskConservatively => HasMask && technique == ShadowTechnique.Pcss;

        internal bool MasksConservatively => conservativeMask && CanMaskConservatively;

        internal bool HasContactShadows => contactShadowMetres > 0.0f;

        /// <summary>Whether the visibility has noise that frames can average.</summary>
        internal bool HasNoise => HasContactShadows || angularDiameterDegrees > 0.0f && (Entry.takesSamples || DrawsVisibility);

        internal bool Accumulates => accumulates && HasNoise;

        /// <summary>
        /// The parameters of the pass of contact shadows; those that no option sets are as the study measures them.
        /// </summary>
        internal ScreenTraceParameters ContactShadows()
        {
            ScreenTraceParameters parameters = ScreenTraceParameters.Default;
            parameters.traceLengthMetres = contactShadowMetres;
            parameters.traceSteps = contactShadowSteps;
            return parameters;
        }

        /// <summary>
        /// Whether the technique has passes of its own: they make maps from the shadow map before its filter, or draw
        /// the visibility.
        /// </summary>
        internal bool HasPasses => Entry.formats[0].graph != null;

        /// <summary>
        /// Whether the technique's passes draw the visibility, in place of the feature's own over the screen.
        /// </summary>
        internal bool DrawsVisibility => HasPasses && Entry.formats[0].graph.visibility != TechniqueGraph.None;

        /// <summary>
        /// Whether the technique's passes, or the feature's with its filter, can draw at half resolution.
        /// </summary>
        internal bool CanHalveResolution => !DrawsVisibility || Entry.halfGraph != null;

        internal bool HalvesResolution => halfResolution && CanHalveResolution;

        /// <summary>The graph of a technique with passes of its own.</summary>
        internal TechniqueGraph OwnGraph => DrawsVisibility && HalvesResolution ? Entry.halfGraph : Format.graph;

        /// <summary>Whether the technique has maps of either format.</summary>
        internal bool HasMapFormats => Entry.formats.Length > 1;

        /// <summary>What Techniques.txt says about the technique.</summary>
        private TechniqueEntry Entry => technique.Entry();

        /// <summary>The technique's graph and parameters, by the format of its maps.</summary>
        internal TechniqueFormat Format => Entry.formats[FormatIndex];

        internal int FormatIndex => HasMapFormats && mapFormat == MapFormat.Bits16 ? 1 : 0;

        /// <summary>
        /// The filters' parameters. Those that no option sets have the values that the study measures
        /// (SoftShadowParameters); PCSS (HDRP) has HDRP's own limits.
        /// </summary>
        public SoftShadowParameters Parameters()
        {
            bool hdrp = technique == ShadowTechnique.PcssHdrp;
            SoftShadowParameters parameters = hdrp ? SoftShadowParameters.HdrpDefault : SoftShadowParameters.Default;
            parameters.AngularDiameterDegrees = angularDiameterDegrees;
            parameters.CascadeBorder = cascadeBlend;
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
