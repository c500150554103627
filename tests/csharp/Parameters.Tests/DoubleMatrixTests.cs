namespace Penumbra.Tests;

public class DoubleMatrixTests
{
    private static double[] Entries(in DoubleMatrix m) => new[]
    {
        m.Column0.X, m.Column0.Y, m.Column0.Z, m.Column0.W, m.Column1.X, m.Column1.Y, m.Column1.Z, m.Column1.W,
        m.Column2.X, m.Column2.Y, m.Column2.Z, m.Column2.W, m.Column3.X, m.Column3.Y, m.Column3.Z, m.Column3.W,
    };

    private static void AssertInverts(Matrix4x4 matrix, double tolerance)
    {
        var given = DoubleMatrix.From(matrix);
        Assert.That(given.TryInvert(out var inverse));
        AssertIdentity(DoubleMatrix.Product(inverse, given), tolerance);
        AssertIdentity(DoubleMatrix.Product(given, inverse), tolerance);
    }

    private static void AssertIdentity(in DoubleMatrix matrix, double tolerance)
    {
        var entries = Entries(matrix);
        for (var i = 0; i < entries.Length; ++i)
        {
            Assert.That(entries[i], Is.EqualTo(i % 5 == 0 ? 1.0 : 0.0).Within(tolerance), $"entry {i}");
        }
    }

    [Test]
    public void FullMatricesAreInverted()
    {
        var random = new Random(17);
        for (var i = 0; i < 1000; ++i)
        {
            double Entry(int row, int column) => random.NextDouble() * 2 - 1 + (row == column ? 3 : 0);
            AssertInverts(Adversary.Build((row, column) => (float)Entry(row, column)), 1e-13);
        }
    }

    [Test]
    public void SizesFromOneEndOfTheFloatsToTheOtherAreInverted()
    {
        foreach (var scale in new[] { float.Epsilon, 1e-38f, 1e-10f, 1e10f, float.MaxValue })
        {
            AssertInverts(Adversary.Build((row, column) => row == column ? scale : 0.0f), 1e-12);
        }
    }
}
