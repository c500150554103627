namespace Penumbra.Tests;

/// <summary>Makes inputs that callers should never pass and one day will; they are the same every time.</summary>
internal static class Adversary
{
    public static readonly float[] Floats =
    {
        0.0f, -0.0f, 1.0f, -1.0f, float.Epsilon, 1e-38f, 1e-20f, 1e20f, float.MaxValue, float.MinValue,
        float.PositiveInfinity, float.NegativeInfinity, float.NaN,
    };

    public static readonly int[] Ints = { int.MinValue, -1, 0, 1, 64, 129, int.MaxValue };

    /// <summary>
    /// Matrices with all entries alike; with one entry changed in a good matrix; with every entry drawn from the list.
    /// </summary>
    public static IEnumerable<Matrix4x4> Matrices(Matrix4x4 good)
    {
        var random = new Random(7);
        foreach (var value in Floats)
        {
            yield return Build((row, column) => value);
            for (var entry = 0; entry < 16; ++entry)
            {
                var at = entry;
                yield return Build((row, column) => 4 * row + column == at ? value : Entry(good, row, column));
            }
        }
        for (var i = 0; i < 2000; ++i) yield return Build((row, column) => Floats[random.Next(Floats.Length)]);
    }

    /// <summary>Matrices with each row in turn zero, a copy of another, and the sum of two others.</summary>
    public static IEnumerable<Matrix4x4> Singular(Matrix4x4 good)
    {
        for (var dead = 0; dead < 4; ++dead)
        {
            var at = dead;
            float Of(int row, int column) => Entry(good, row % 4, column);
            yield return Build((row, column) => row == at ? 0.0f : Of(row, column));
            yield return Build((row, column) => row == at ? Of(row + 1, column) : Of(row, column));
            yield return Build((row, column) => column == at ? 0.0f : Of(row, column));
        }
        yield return default;
    }

    public static Matrix4x4 Build(Func<int, int, float> entry)
    {
        Vector4 Column(int c) => new Vector4(entry(0, c), entry(1, c), entry(2, c), entry(3, c));
        return new Matrix4x4(Column(0), Column(1), Column(2), Column(3));
    }

    public static float Entry(Matrix4x4 m, int row, int column)
    {
        var r = m.GetRow(row);
        return column == 0 ? r.x : column == 1 ? r.y : column == 2 ? r.z : r.w;
    }

    public static bool IsFinite(Vector4 v) =>
        float.IsFinite(v.x) && float.IsFinite(v.y) && float.IsFinite(v.z) && float.IsFinite(v.w);

    public static bool IsFinite(Matrix4x4 m) =>
        IsFinite(m.GetRow(0)) && IsFinite(m.GetRow(1)) && IsFinite(m.GetRow(2)) && IsFinite(m.GetRow(3));
}
