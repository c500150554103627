using System;
using System.Globalization;

namespace Penumbra
{
    /// <summary>
    /// The apparent size of the light: the full angle a of its disc, and tan(a/2), which shaders use. A blocker at
    /// distance gap in front of a receiver has a penumbra of radius tan(a/2) * gap; an edge goes from dark to lit over
    /// twice that radius.
    /// <para>Angles come in degrees; tangents are unitless. Both conversions are computed in double and rounded
    /// once.</para>
    /// </summary>
    public static class AngularDiameter
    {
        /// <summary>A point light source: shadows are hard.</summary>
        public const float SmallestDegrees = 0.0f;

        public const float LargestDegrees = 30.0f;

        /// <summary>The sun's angular diameter, seen from Earth.</summary>
        public const float SunDegrees = 0.53f;

        /// <summary>tan(a/2). Degrees are clamped to the range, and NaN counts as 0; 0 gives exactly 0.</summary>
        public static float TanHalf(float degrees) => (float)TanHalfInDouble(degrees, LargestDegrees);

        /// <summary>The inverse: 2 atan(tanHalf) in degrees. Values that are not positive give 0.</summary>
        public static float FromTanHalf(float tanHalf) =>
            tanHalf > 0.0f ? (float)(Math.Atan(tanHalf) * 360.0 / Math.PI) : 0.0f;

        /// <summary>
        /// The problem of an angle that is not in range, as an inspector message: what is wrong and how to fix it. Null
        /// if the angle is in range.
        /// </summary>
        public static string Problem(float degrees)
        {
            if (degrees >= SmallestDegrees && degrees <= LargestDegrees) return null;
            return string.Format(CultureInfo.InvariantCulture,
                                 "angular diameter is {0}, outside {1} .. {2} degrees; it is the full angle of the " +
                                 "light's disc, and the sun's is {3}",
                                 degrees, SmallestDegrees, LargestDegrees, SunDegrees);
        }

        /// <summary>tan(a/2) before rounding, for further computation in double.</summary>
        internal static double TanHalfInDouble(float degrees, float largestDegrees) =>
            Math.Tan(Bounded.OrLow(degrees, SmallestDegrees, largestDegrees) * Math.PI / 360.0);
    }
}
