using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// The uniforms of Shadows.hlsl: the light's vectors, and the parameters of each PCSS technique.
    /// <para>Every packed component is finite and in the range that the shaders accept, for any parameters; the
    /// shader chooses the Poisson set's size.</para>
    /// </summary>
    public readonly struct ShadowUniforms
    {
        // The shaders' noise repeats after this many frames; a small index fits a float however long the game runs.
        private const int NoiseFrames = 64;

        /// <summary>_PenumbraMainLightAtlasTexelSize: 1/width, 1/height, width, height.</summary>
        public readonly Vector4 MainLightAtlasTexelSize;

        /// <summary>_PenumbraMainLightParams: cascade count, tan(a/2), frame index of the noise, border between
        /// cascades.</summary>
        public readonly Vector4 MainLightParams;

        /// <summary>Parameters of the technique _PENUMBRA_PCSS.</summary>
        public readonly PcssAngularParameters PcssAngular;

        /// <summary>Parameters of the technique _PENUMBRA_PCSS_POISSON.</summary>
        public readonly PcssClassicParameters PcssClassic;

        /// <summary>Parameters of the technique _PENUMBRA_PCSS_HDRP.</summary>
        public readonly PcssHdrpParameters PcssHdrp;

        /// <param name="frameIndex">Changes the noise pattern. Static if always 0; increase it for temporal
        /// filters.</param>
        public ShadowUniforms(in SoftShadowParameters parameters, in AtlasLayout layout, int frameIndex)
        {
            MainLightAtlasTexelSize = layout.TexelSize;
            MainLightParams = new Vector4(layout.Cascades, AngularDiameter.TanHalf(parameters.AngularDiameterDegrees),
                                          frameIndex & (NoiseFrames - 1),
                                          Bounded.OrLow(parameters.CascadeBorder, 0.0f, 1.0f));
            PcssAngular = new PcssAngularParameters
            {
                blockerSamples = parameters.BlockerSamples, filterSamples = parameters.FilterSamples,
                blockerClump = parameters.BlockerClump, minFilterTexels = parameters.MinFilterTexels,
                maxPenumbraMetres = parameters.MaxPenumbraMetres, maxSamplingMetres = parameters.MaxSamplingMetres,
            };
            PcssClassic = new PcssClassicParameters
            {
                samples = parameters.BlockerSamples, searchRadiusMetres = parameters.SearchRadiusMetres,
                minFilterTexels = parameters.MinFilterTexels,
            };
            var cones = new HdrpCones(parameters, parameters.AngularDiameterDegrees);
            PcssHdrp = new PcssHdrpParameters
            {
                blockerSamples = parameters.BlockerSamples, filterSamples = parameters.FilterSamples,
                blockerClump = parameters.BlockerClump, minFilterTexels = parameters.MinFilterTexels,
                maxPenumbraMetres = parameters.MaxPenumbraMetres, maxSamplingMetres = parameters.MaxSamplingMetres,
                searchTanHalf = (float)cones.SearchTanHalf, minFilterTanHalf = (float)cones.MinFilterTanHalf,
            };
        }

        /// <summary>The value of a uniform of one of the techniques' parameters; false for other uniforms.</summary>
        internal bool TryGet(int uniform, out Vector4 vector)
        {
            vector = default;
            if (uniform == PcssAngularParameters.Uniform0) vector = PcssAngular.Vector0;
            else if (uniform == PcssAngularParameters.Uniform1) vector = PcssAngular.Vector1;
            else if (uniform == PcssClassicParameters.Uniform0) vector = PcssClassic.Vector0;
            else if (uniform == PcssHdrpParameters.Uniform0) vector = PcssHdrp.Vector0;
            else if (uniform == PcssHdrpParameters.Uniform1) vector = PcssHdrp.Vector1;
            else return false;
            return true;
        }
    }
}
