namespace Penumbra.Tests;

/// <summary>Matrices that are no map; tests/golden/parameters.json has those that are.</summary>
public class CascadeScalesTests
{
    [Test]
    public void UrpsEntriesBeyondTheCountAreNoMap([Values] bool reversedZ, [Values(0.0f, 0.53f)] float degrees)
    {
        var scales = new CascadeScales(LightFrustum.NoOp(reversedZ), new AtlasLayout(2048, 4), degrees);
        AssertNoMap(scales);
    }

    private static void AssertNoMap(in CascadeScales scales)
    {
        Assert.That(scales.IsMapped, Is.False);
        Assert.That(Figures(scales), Is.All.Zero);
        var bias = ShadowBias.OfCascade(scales, 1.0f, 1.0f, SoftShadowKernel.Medium);
        Assert.That(bias, Is.EqualTo(Vector2.zero));
    }

    private static float[] Figures(in CascadeScales scales) => new[]
    {
        scales.UvPerMetre, scales.DepthPerMetre, scales.DepthToRadial, scales.RadialToDepth, scales.DepthToRadialHdrp,
        scales.TexelSizeMetres, scales.MaxPenumbraTexels,
    };

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
                foreach (var figure in Figures(scales))
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
