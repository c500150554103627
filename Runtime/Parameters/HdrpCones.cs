using System;

namespace Penumbra
{
    /// <summary>
    /// HDRP's two further cones: the blocker search's is never narrower than the light's, and the one of the smallest
    /// filter radius is never narrower than the search's. Tangents of half the angle, before rounding.
    /// <para>Source: HDRP's request settings of a directional light's PCSS (HDShadowRequest, version 17).</para>
    /// </summary>
    internal readonly struct HdrpCones
    {
        private const float LargestDegrees = 90.0f;

        public readonly double SearchTanHalf;
        public readonly double MinFilterTanHalf;

        public HdrpCones(in SoftShadowParameters parameters, float lightDegrees)
            : this(parameters, AngularDiameter.TanHalfInDouble(lightDegrees, AngularDiameter.LargestDegrees)) { }

        public HdrpCones(in SoftShadowParameters parameters, double lightTanHalf)
        {
            SearchTanHalf = Math.Max(lightTanHalf, TanHalf(parameters.HdrpSearchDegrees));
            MinFilterTanHalf = Math.Max(SearchTanHalf, TanHalf(parameters.HdrpMinFilterDegrees));
        }

        private static double TanHalf(float degrees) => AngularDiameter.TanHalfInDouble(degrees, LargestDegrees);
    }
}
