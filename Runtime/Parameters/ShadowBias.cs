using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// URP's bias of shadow casters, as in ShadowUtils.GetShadowBias for a directional light: the asset's unitless
    /// settings, times the size of a texel, times the radius of the soft kernel. It moves
    /// casters away from the light and inwards along the normal.
    /// <para>Metres, x along the light, y against the normal, both at most 0: _ShadowBias.xy. Results that do not fit
    /// a float, and cascades without a map, give 0.</para>
    /// </summary>
    public static class ShadowBias
    {
        /// <summary>Radius of URP's filter at this quality, in texels. An unknown quality counts as medium.</summary>
        public static float KernelRadiusTexels(SoftShadowKernel kernel)
        {
            switch (kernel)
            {
                case SoftShadowKernel.Off: return 1.0f;
                case SoftShadowKernel.Low: return 1.5f;
                case SoftShadowKernel.High: return 3.5f;
                default: return 2.5f;
            }
        }

        /// <param name="depthBias">The asset's or the light's setting, unitless; likewise normalBias.</param>
        public static Vector2 OfCascade(in CascadeScales scales, float depthBias, float normalBias,
                                        SoftShadowKernel kernel) =>
            OfTexel(scales.TexelSizeInDouble, depthBias, normalBias, kernel);

        /// <summary>The bias from the light's projection, whose frustum is 2 / m00 metres wide.</summary>
        /// <param name="lightProjection">Light view to clip, in any depth convention.</param>
        public static Vector2 OfProjection(in Matrix4x4 lightProjection, int tileResolution, float depthBias,
                                           float normalBias, SoftShadowKernel kernel) =>
            OfTexel(2.0 / lightProjection.m00 / tileResolution, depthBias, normalBias, kernel);

        private static Vector2 OfTexel(double metres, float depthBias, float normalBias, SoftShadowKernel kernel)
        {
            var radius = KernelRadiusTexels(kernel) * metres;
            return new Vector2(Toward(depthBias * radius), Toward(normalBias * radius));
        }

        // The value is subtracted from 0, so that no bias is 0 and not -0.
        private static float Toward(double metres) => Bounded.FitsFloat(metres) ? (float)(0.0 - metres) : 0.0f;
    }
}
