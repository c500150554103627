using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// The two vectors that HDRP packs for each cascade of a directional light's PCSS, for HDRP custom passes and for
    /// shaders ported from it. Its scale of depth to radius is s = |m00 / m22| of the device projection, which is
    /// 2 UvPerMetre / DepthPerMetre: penumbrae come out twice the geometric width, as HDRP's do.
    /// <para>With t = tan(a/2) and the tangents of the other two cones, ts (search) and tf (smallest filter):</para>
    /// <code>
    ///   Params0   t s | 1 / (t s) | widest penumbra / (2 t), metres | cone height, metres
    ///   Params1   smallest filter, texels | 1 / (tf s) | 1 / (ts s) | clump / 2
    /// </code>
    /// <para>Every component is finite. At 0 degrees, where HDRP divides by 0, inverses are 0 and the largest blocker
    /// distance is the cascade's depth range; a cascade without a map has scales of 0.</para>
    /// </summary>
    public readonly struct HdrpShadowParameters
    {
        // At 1, samples are uniform over the area; HDRP allows no lower value.
        private const float SmallestClump = 1.0f;
        private const float LargestClump = 8.0f;
        private const float LongestMetres = 1e6f;
        private const float WidestFilterTexels = 64.0f;

        public readonly Vector4 Params0;
        public readonly Vector4 Params1;

        /// <param name="scales">Scales of the cascade; they contain the light's angular diameter.</param>
        public HdrpShadowParameters(in CascadeScales scales, in SoftShadowParameters parameters)
        {
            var radialPerDepth = scales.IsMapped ? 2.0 * scales.UvPerMetreInDouble / scales.DepthPerMetreInDouble : 0.0;
            var cones = new HdrpCones(parameters, scales.TanHalf);
            var widest = Bounded.OrLow(parameters.MaxPenumbraMetres, 0.0f, LongestMetres);
            var farthest = widest / (2.0 * scales.TanHalf);
            var clump = Bounded.OrLow(parameters.BlockerClump, SmallestClump, LargestClump);
            Params0 = new Vector4((float)(scales.TanHalf * radialPerDepth), Inverse(scales.TanHalf * radialPerDepth),
                                  (float)(Bounded.FitsFloat(farthest) ? farthest : scales.DepthRangeMetres),
                                  Bounded.OrLow(parameters.MaxSamplingMetres, 0.0f, LongestMetres));
            Params1 = new Vector4(
                Bounded.OrLow(parameters.MinFilterTexels, 0.0f, WidestFilterTexels),
                Inverse(cones.MinFilterTanHalf * radialPerDepth), Inverse(cones.SearchTanHalf * radialPerDepth),
                0.5f * clump);
        }

        private static float Inverse(double scale)
        {
            var inverse = 1.0 / scale;
            return scale > 0.0 && Bounded.FitsFloat(inverse) ? (float)inverse : 0.0f;
        }
    }
}
