namespace Penumbra.Tests;

/// <summary>Distances between floats in units of the last place.</summary>
internal static class Ulp
{
    /// <summary>
    /// The number of floats between both; the two zeros are one float. A number that is not finite is infinitely far.
    /// </summary>
    public static double Distance(float actual, float expected)
    {
        if (!float.IsFinite(actual) || !float.IsFinite(expected)) return double.PositiveInfinity;
        return Math.Abs((double)Ordinal(actual) - Ordinal(expected));
    }

    /// <summary>
    /// The distance in the spacing of floats at `expected`, or, for an entry smaller than 2^-24 of its row's
    /// largest, in the spacing there: what is below the row's own rounding cannot be seen in a position. `penumbra
    /// constants` counts in the same way.
    /// </summary>
    public static double InRow(float actual, float expected, float rowLargest)
    {
        if (!float.IsFinite(actual) || !float.IsFinite(expected)) return double.PositiveInfinity;
        var at = (float)Math.Max(Math.Abs((double)expected), Math.Abs((double)rowLargest) / (1 << 24));
        return Math.Abs((double)actual - expected) / (MathF.BitIncrement(at) - (double)at);
    }

    private static long Ordinal(float value)
    {
        var bits = BitConverter.SingleToInt32Bits(value);
        return bits >= 0 ? bits : -(bits & 0x7FFFFFFF);
    }
}
