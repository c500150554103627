namespace Penumbra
{
    /// <summary>Clamps values as the shaders do (BoundedOrLow): NaN gives the low end, and 0 has no sign.</summary>
    internal static class Bounded
    {
        public static float OrLow(float value, float low, float high) =>
            value > low ? value < high ? value : high : low;

        public static int Count(int value, int low, int high) => value < low ? low : value > high ? high : value;

        /// <summary>Whether the value fits a float: not NaN, and not infinite once rounded.</summary>
        public static bool FitsFloat(double value)
        {
            var rounded = (float)value;
            return rounded >= -float.MaxValue && rounded <= float.MaxValue;
        }
    }
}
