using NUnit.Framework;

namespace Penumbra.Tests;

[TestFixture]
public class CascadeScalesTests
{
    private const double Rounding = 1e-6;

    [Test]
    public void AMetreIsWhatTheFrustumMakesOfIt([Values] bool reversedZ, [Values(1, 2, 3, 4)] int cascades)
    {
        var frustum = new LightFrustum
        {
            ReversedZ = reversedZ, Layout = new AtlasLayout(2048, cascades), Cascade = cascades - 1,
        };
        var scales = frustum.Scales(0.53f);
        Assert.That(scales.IsMapped);
        Assert.That(scales.UvPerMetre * frustum.Width, Is.EqualTo(1.0).Within(Rounding));
        Assert.That(scales.DepthPerMetre * frustum.Range, Is.EqualTo(1.0).Within(Rounding));
        Assert.That(scales.TexelSizeMetres * frustum.Layout.TileResolution / frustum.Width,
                    Is.EqualTo(1.0).Within(Rounding));
    }

    // A blocker 7 m in front of the receiver blurs its edge over tan(a/2) * 7 m to each side.
    [Test]
    public void TheRadiusIsTheDiscsSeenFromTheBlocker([Values(0.53f, 5.0f, 30.0f)] float degrees)
    {
        var frustum = new LightFrustum();
        var scales = frustum.Scales(degrees);
        var tileRadius = scales.DepthToRadial * (7.0 * scales.DepthPerMetre);
        var metres = Math.Tan(degrees * Math.PI / 360.0) * 7.0;
        Assert.That(tileRadius * frustum.Width / metres, Is.EqualTo(1.0).Within(Rounding));
        var texels = Math.Tan(degrees * Math.PI / 360.0) * frustum.Range / scales.TexelSizeMetres;
        Assert.That(scales.MaxPenumbraTexels / texels, Is.EqualTo(1.0).Within(Rounding));
    }

    [Test]
    public void TheInverseIsOneUnlessTheLightIsAPoint([Values(1e-6f, 0.53f, 30.0f)] float degrees)
    {
        var scales = new LightFrustum().Scales(degrees);
        Assert.That((double)scales.DepthToRadial * scales.RadialToDepth, Is.EqualTo(1.0).Within(Rounding));
        var point = new LightFrustum().Scales(0.0f);
        Assert.That(point.IsMapped);
        Assert.That(point.DepthToRadial, Is.Zero);
        Assert.That(point.RadialToDepth, Is.Zero);
        Assert.That(point.MaxPenumbraTexels, Is.Zero);
    }

    [Test]
    public void HdrpsRatioIsTheDeviceProjections([Values] bool reversedZ)
    {
        var frustum = new LightFrustum { ReversedZ = reversedZ };
        var expected = Math.Tan(4.0 * Math.PI / 360.0) * Math.Abs(frustum.M00 / frustum.DeviceM22);
        Assert.That(frustum.Scales(4.0f).DepthToRadialHdrp / expected, Is.EqualTo(1.0).Within(Rounding));
    }

    [Test]
    public void UrpsEntriesBeyondTheCountAreNoMap([Values] bool reversedZ, [Values(0.0f, 0.53f)] float degrees)
    {
        var scales = new CascadeScales(LightFrustum.NoOp(reversedZ), new AtlasLayout(2048, 4), degrees);
        AssertNoMap(scales);
    }

    private static void AssertNoMap(in CascadeScales scales)
    {
        Assert.That(scales.IsMapped, Is.False);
        Assert.That(new[]
                    {
                        scales.UvPerMetre, scales.DepthPerMetre, scales.DepthToRadial, scales.RadialToDepth,
                        scales.DepthToRadialHdrp, scales.TexelSizeMetres, scales.MaxPenumbraTexels,
                    },
                    Is.All.Zero);
        var bias = ShadowBias.OfCascade(scales, 1.0f, 1.0f, SoftShadowKernel.Medium);
        Assert.That(bias, Is.EqualTo(Vector2.zero));
    }

    [Test]
    public void AMapWithoutBothRowsIsNoMap([Values(0, 2)] int row,
                                           [Values(0.0f, float.NaN, float.PositiveInfinity)] float value)
    {
        var good = new LightFrustum().WorldToShadow;
        var bad = Adversary.Build((r, c) => r == row && c < 3 ? value : Adversary.Entry(good, r, c));
        AssertNoMap(new CascadeScales(bad, new AtlasLayout(2048, 4), 0.53f));
    }

    // The scale is half a UV per smallest float of metres, so that a texel has more metres than a float holds.
    [Test]
    public void ScalesNoFloatHoldsAreNoMap()
    {
        var tiny = Adversary.Build((r, c) => r == c ? float.Epsilon : 0.0f);
        AssertNoMap(new CascadeScales(tiny, new AtlasLayout(2048, 4), 0.53f));
    }

    [Test]
    public void EveryFigureIsFiniteWhateverTheMatrix()
    {
        var mapped = 0;
        foreach (var matrix in Adversary.Matrices(new LightFrustum().WorldToShadow))
        {
            foreach (var degrees in Adversary.Floats)
            {
                var scales = new CascadeScales(matrix, new AtlasLayout(2048, 4), degrees);
                mapped += scales.IsMapped ? 1 : 0;
                var all = new[]
                {
                    scales.UvPerMetre, scales.DepthPerMetre, scales.DepthToRadial, scales.RadialToDepth,
                    scales.DepthToRadialHdrp, scales.TexelSizeMetres, scales.MaxPenumbraTexels,
                };
                foreach (var figure in all)
                {
                    if (!(figure >= 0.0f && figure <= float.MaxValue)) Assert.Fail($"{figure} of\n{Rows(matrix)}");
                }
                if (!scales.IsMapped) AssertNoMap(scales);
            }
        }
        Assert.That(mapped, Is.GreaterThan(1000), "only a test if many of them are mapped");
    }

    private static string Rows(Matrix4x4 m) => $"{m.GetRow(0)}\n{m.GetRow(1)}\n{m.GetRow(2)}\n{m.GetRow(3)}";
}
