using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// The vectors Shadows.hlsl reads, packed: one per global, named after it.
    /// <para>Whatever the parameters hold, every component is finite and in the range the shaders take; a Poisson
    /// set's size is chosen by the shader.</para>
    /// </summary>
    public readonly struct ShadowUniforms
    {
        internal const float LongestMetres = 1e6f;
        internal const float WidestFilterTexels = 64.0f;
        internal const float LargestClump = 8.0f;
        internal const int MostSamples = 128;

        // The shaders' noise repeats after as many frames; a float holds the index then, however long the game runs.
        private const int NoiseFrames = 64;

        /// <summary>_PenumbraMainLightAtlasTexelSize: 1/width, 1/height, width, height.</summary>
        public readonly Vector4 MainLightAtlasTexelSize;

        /// <summary>_PenumbraMainLightParams: cascade count, tan(a/2), frame index of the noise, 0.</summary>
        public readonly Vector4 MainLightParams;

        /// <summary>_PenumbraSamples: blocker samples, filter samples, clump, smallest filter radius in texels.
        /// </summary>
        public readonly Vector4 Samples;

        /// <summary>_PenumbraLimits: widest penumbra, cone height, classic search radius, 0; metres.</summary>
        public readonly Vector4 Limits;

        /// <summary>_PenumbraHdrp: tan of half HDRP's search angle and of half its smallest filter's, 0, 0.</summary>
        public readonly Vector4 Hdrp;

        /// <param name="frameIndex">Turns the noise. 0 always leaves it static; count up for temporal filters.</param>
        public ShadowUniforms(in SoftShadowParameters parameters, in AtlasLayout layout, int frameIndex)
        {
            MainLightAtlasTexelSize = layout.TexelSize;
            MainLightParams = new Vector4(layout.Cascades, AngularDiameter.TanHalf(parameters.AngularDiameterDegrees),
                                          frameIndex & (NoiseFrames - 1), 0.0f);
            Samples = new Vector4(Bounded.Count(parameters.BlockerSamples, 1, MostSamples),
                                  Bounded.Count(parameters.FilterSamples, 1, MostSamples),
                                  Bounded.OrLow(parameters.BlockerClump, 0.0f, LargestClump),
                                  Bounded.OrLow(parameters.MinFilterTexels, 0.0f, WidestFilterTexels));
            Limits = new Vector4(Bounded.OrLow(parameters.MaxPenumbraMetres, 0.0f, LongestMetres),
                                 Bounded.OrLow(parameters.MaxSamplingMetres, 0.0f, LongestMetres),
                                 Bounded.OrLow(parameters.SearchRadiusMetres, 0.0f, LongestMetres), 0.0f);
            var cones = new HdrpCones(parameters, parameters.AngularDiameterDegrees);
            Hdrp = new Vector4((float)cones.SearchTanHalf, (float)cones.MinFilterTanHalf, 0.0f, 0.0f);
        }
    }
}
