using System;
using System.Globalization;

namespace Penumbra
{
    /// <summary>
    /// How large the light looks: the full angle of its disc, and the tangent of half of it, which is what shaders
    /// take. A blocker a gap in front of a receiver throws a penumbra of radius tan(a/2) * gap: an edge goes from
    /// dark to lit over twice that.
    /// <para>Degrees in; tangents have no unit. Both directions round once, from double.</para>
    /// </summary>
    public static class AngularDiameter
    {
        /// <summary>A point: shadows are hard.</summary>
        public const float SmallestDegrees = 0.0f;

        public const float LargestDegrees = 30.0f;

        /// <summary>The sun's, seen from the earth.</summary>
        public const float SunDegrees = 0.53f;

        /// <summary>tan(a/2). Degrees outside the range count as its nearer end, NaN as 0; 0 gives exactly 0.</summary>
        public static float TanHalf(float degrees) => (float)TanHalfInDouble(degrees, LargestDegrees);

        /// <summary>The inverse: 2 atan(tanHalf) in degrees. What is not positive gives 0.</summary>
        public static float FromTanHalf(float tanHalf) =>
            tanHalf > 0.0f ? (float)(Math.Atan(tanHalf) * 360.0 / Math.PI) : 0.0f;

        /// <summary>Null where the angle is in range; else what is wrong and what to do, for an inspector.</summary>
        public static string Problem(float degrees)
        {
            if (degrees >= SmallestDegrees && degrees <= LargestDegrees) return null;
            return string.Format(CultureInfo.InvariantCulture,
                                 "angular diameter is {0}, outside {1} .. {2} degrees; it is the full angle of the " +
                                 "light's disc, and the sun's is {3}",
                                 degrees, SmallestDegrees, LargestDegrees, SunDegrees);
        }

        /// <summary>The same before it is rounded, for figures that go on from it.</summary>
        internal static double TanHalfInDouble(float degrees, float largestDegrees) =>
            Math.Tan(Bounded.OrLow(degrees, SmallestDegrees, largestDegrees) * Math.PI / 360.0);
    }
}
