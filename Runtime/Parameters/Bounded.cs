namespace Penumbra
{
    /// <summary>
    /// A value kept in a range as the shaders keep theirs (BoundedOrLow): NaN gives the low end, and 0 has no sign.
    /// </summary>
    internal static class Bounded
    {
        public static float OrLow(float value, float low, float high) =>
            value > low ? value < high ? value : high : low;

        public static int Count(int value, int low, int high) => value < low ? low : value > high ? high : value;

        /// <summary>Whether a float holds it: not NaN, and no infinity once rounded.</summary>
        public static bool FitsFloat(double value)
        {
            var rounded = (float)value;
            return rounded >= -float.MaxValue && rounded <= float.MaxValue;
        }
    }
}
