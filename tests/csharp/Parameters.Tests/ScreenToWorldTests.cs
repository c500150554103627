using NUnit.Framework;

namespace Penumbra.Tests;

[TestFixture]
public class ScreenToWorldTests
{
    // The view turns and moves, and the projection is off-centre, to reversed depth 0 .. 1.
    private static readonly Matrix4x4 View = Rows(new Vector4(0.8f, 0, -0.6f, 3), new Vector4(0, 1, 0, -2),
                                                  new Vector4(0.6f, 0, 0.8f, -5), new Vector4(0, 0, 0, 1));

    private static Matrix4x4 Projection(float near, float far) =>
        Rows(new Vector4(0.9f, 0, 0.2f, 0), new Vector4(0, 1.6f, -0.1f, 0),
             new Vector4(0, 0, near / (far - near), near * far / (far - near)), new Vector4(0, 0, -1, 0));

    private static Matrix4x4 Rows(Vector4 x, Vector4 y, Vector4 z, Vector4 w) =>
        Adversary.Build((row, column) => Adversary.Entry(new Matrix4x4(x, y, z, w), column, row));

    // The device makes this of a projection to reversed depth.
    private static Matrix4x4 OnDevice(Matrix4x4 reversed, bool flipped, bool reversedZ, bool zeroToOne) =>
        Adversary.Build((row, column) =>
        {
            var entry = Adversary.Entry(reversed, row, column);
            var w = Adversary.Entry(reversed, 3, column);
            if (row == 1 && flipped) return -entry;
            if (row != 2) return entry;
            var depth = reversedZ ? entry : w - entry;
            return zeroToOne ? depth : 2.0f * depth - w;
        });

    // Takes a world point to (u, v, stored depth) the way a GPU gets there, in double.
    private static Vector4 Stored(Matrix4x4 view, Matrix4x4 projection, double[] world, ScreenConventions conventions)
    {
        var clip = Times(projection, Times(view, world));
        double x = clip[0] / clip[3], y = clip[1] / clip[3], z = clip[2] / clip[3];
        var v = conventions.UvStartsAtTop ? 0.5 - 0.5 * y : 0.5 + 0.5 * y;
        var depth = conventions.DepthIsZeroToOne ? z : 0.5 + 0.5 * z;
        return new Vector4((float)(0.5 + 0.5 * x), (float)v, (float)depth, 1.0f);
    }

    private static double[] Times(Matrix4x4 m, double[] p)
    {
        var product = new double[4];
        for (var row = 0; row < 4; ++row)
        {
            for (var column = 0; column < 4; ++column)
            {
                product[row] += (double)Adversary.Entry(m, row, column) * p[column];
            }
        }
        return product;
    }

    [Test]
    public void PixelsComeBackToTheirWorldPosition([Values] bool flipped, [Values] bool reversedZ,
                                                   [Values] bool uvStartsAtTop, [Values] bool depthIsZeroToOne)
    {
        var conventions = new ScreenConventions(uvStartsAtTop, depthIsZeroToOne);
        var projection = OnDevice(Projection(0.3f, 60.0f), flipped, reversedZ, depthIsZeroToOne);
        Assert.That(ScreenToWorld.TryGet(View, projection, conventions, out var screenToWorld));
        var random = new Random(1);
        for (var i = 0; i < 200; ++i)
        {
            double From(double low, double high) => low + (high - low) * random.NextDouble();
            var world = new[] { From(-4, 4), From(0, 8), From(-32, -2), 1 };
            var stored = Stored(View, projection, world, conventions);
            var back = Times(screenToWorld, new double[] { stored.x, stored.y, stored.z, stored.w });
            for (var axis = 0; axis < 3; ++axis)
            {
                // The depth is a float: half an ULP of 1 is (distance^2 / near) 6e-8, a millimetre at 50 m.
                Assert.That(back[axis] / back[3], Is.EqualTo(world[axis]).Within(2e-3), $"axis {axis}");
            }
        }
    }

    [Test]
    public void TheFirstRowIsTheTopWhereTheDeviceSaysSo([Values] bool uvStartsAtTop)
    {
        var conventions = new ScreenConventions(uvStartsAtTop, true);
        ScreenToWorld.TryGet(Matrix4x4.identity, Projection(0.3f, 60.0f), conventions, out var matrix);
        var corner = matrix * new Vector4(0.0f, 0.0f, 0.5f, 1.0f);
        Assert.That(corner.x / corner.w, Is.LessThan(0.0f));
        Assert.That(corner.y / corner.w, uvStartsAtTop ? Is.GreaterThan(0.0f) : Is.LessThan(0.0f));
    }

    [Test]
    public void FarFromTheOriginPositionsKeepWhatAFloatHolds()
    {
        var view = View;
        view.m03 = -30000.0f;
        view.m23 = 40000.0f;
        var projection = OnDevice(Projection(1e-3f, 1e5f), true, true, true);
        Assert.That(ScreenToWorld.TryGet(view, projection, ScreenConventions.Direct3D, out var matrix));
        var viewPoint = new[] { 0.1, -0.2, -2.5, 1.0 };
        var clip = Times(projection, viewPoint);
        var world = Times(matrix, new[]
        {
            0.5 + 0.5 * clip[0] / clip[3], 0.5 - 0.5 * clip[1] / clip[3], clip[2] / clip[3], 1.0,
        });
        var seen = Times(view, new[] { world[0] / world[3], world[1] / world[3], world[2] / world[3], 1.0 });
        // A float holds 50 km to 4 mm; the matrix's few roundings add up to no more than some of these.
        for (var axis = 0; axis < 3; ++axis) Assert.That(seen[axis], Is.EqualTo(viewPoint[axis]).Within(0.02));
    }

    [Test]
    public void ASingularMatrixHasNoAnswerAndGivesTheIdentity()
    {
        var good = Projection(0.3f, 60.0f);
        foreach (var singular in Adversary.Singular(good)) AssertNoAnswer(View, singular);
        foreach (var singular in Adversary.Singular(View)) AssertNoAnswer(singular, good);
    }

    // Row 3 is exactly row 0 plus row 2, of integers whose minors fill a double: the determinant comes out as
    // rounding noise, not as 0.
    [Test]
    public void ASingularMatrixIsSeenThroughTheRounding()
    {
        var random = new Random(11);
        for (var i = 0; i < 500; ++i)
        {
            var rows = new float[12];
            for (var entry = 0; entry < rows.Length; ++entry) rows[entry] = random.Next(-(1 << 20), 1 << 20);
            AssertNoAnswer(View, Adversary.Build((row, column) =>
                row < 3 ? rows[4 * row + column] : rows[column] + rows[8 + column]));
        }
    }

    private static void AssertNoAnswer(Matrix4x4 view, Matrix4x4 projection)
    {
        Assert.That(ScreenToWorld.TryGet(view, projection, ScreenConventions.Direct3D, out var matrix), Is.False);
        Assert.That(matrix, Is.EqualTo(Matrix4x4.identity));
    }

    [Test]
    public void TheMatrixIsFiniteWhateverTheInputs()
    {
        var answers = 0;
        var good = Projection(0.3f, 60.0f);
        foreach (var conventions in new[] { ScreenConventions.Direct3D, ScreenConventions.OpenGL })
        {
            foreach (var matrix in Adversary.Matrices(good))
            {
                answers += ScreenToWorld.TryGet(View, matrix, conventions, out var asProjection) ? 1 : 0;
                answers += ScreenToWorld.TryGet(matrix, good, conventions, out var asView) ? 1 : 0;
                ScreenToWorld.TryGet(matrix, matrix, conventions, out var asBoth);
                Assert.That(Adversary.IsFinite(asProjection) && Adversary.IsFinite(asView));
                Assert.That(Adversary.IsFinite(asBoth));
            }
        }
        Assert.That(answers, Is.GreaterThan(100), "only a test if some have an answer");
    }
}
