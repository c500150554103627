using NUnit.Framework;

namespace Penumbra.Tests;

[TestFixture]
public class AtlasLayoutTests
{
    // Pipelines/Urp.hlsl takes this for granted: extent 1 or 1/2 by the count, tiles two by two.
    [Test]
    public void TilesAreWhereTheShaderLooks([Values(256, 512, 2048, 8192)] int resolution,
                                            [Values(1, 2, 3, 4)] int cascades)
    {
        var layout = new AtlasLayout(resolution, cascades);
        var width = cascades > 1 ? 0.5f : 1.0f;
        var height = cascades > 2 ? 0.5f : 1.0f;
        for (var i = 0; i < cascades; ++i)
        {
            Assert.That(layout.Tile(i), Is.EqualTo(new Vector4(i % 2 * width, i / 2 * height, width, height)));
        }
    }

    [TestCase(1, 2048, 2048)]
    [TestCase(2, 2048, 1024)]
    [TestCase(3, 2048, 2048)]
    [TestCase(4, 2048, 2048)]
    public void OnlyTwoCascadesHalveTheHeight(int cascades, int width, int height)
    {
        var layout = new AtlasLayout(2048, cascades);
        Assert.That(layout.TexelSize, Is.EqualTo(new Vector4(1.0f / width, 1.0f / height, width, height)));
        Assert.That(layout.TileResolution, Is.EqualTo(cascades == 1 ? 2048 : 1024));
    }

    [Test]
    public void TilesAreSquareInTexelsWithinTheMapAndApart([Values(8, 9, 1000, 1023, 16384)] int resolution,
                                                           [Values(1, 2, 3, 4)] int cascades)
    {
        var layout = new AtlasLayout(resolution, cascades);
        for (var i = 0; i < cascades; ++i)
        {
            var tile = layout.Tile(i);
            Assert.That(tile.z * layout.Width, Is.EqualTo(layout.TileResolution).Within(1e-3));
            Assert.That(tile.w * layout.Height, Is.EqualTo(layout.TileResolution).Within(1e-3));
            Assert.That(tile.x + tile.z, Is.LessThanOrEqualTo(1.0f));
            Assert.That(tile.y + tile.w, Is.LessThanOrEqualTo(1.0f));
            for (var j = 0; j < i; ++j)
            {
                var other = layout.Tile(j);
                Assert.That(other.x + other.z <= tile.x || other.y + other.w <= tile.y, $"tiles {j} and {i} meet");
            }
        }
    }

    [TestCase(int.MinValue, 1)]
    [TestCase(0, 1)]
    [TestCase(5, 4)]
    [TestCase(int.MaxValue, 4)]
    public void CountsOutsideTakeTheNearestEnd(int cascades, int nearest) =>
        Assert.That(new AtlasLayout(1024, cascades), Is.EqualTo(new AtlasLayout(1024, nearest)));

    [TestCase(int.MinValue, AtlasLayout.SmallestResolution)]
    [TestCase(0, AtlasLayout.SmallestResolution)]
    [TestCase(int.MaxValue, AtlasLayout.LargestResolution)]
    public void ResolutionsOutsideTakeTheNearestEnd(int resolution, int nearest) =>
        Assert.That(new AtlasLayout(resolution, 4), Is.EqualTo(new AtlasLayout(nearest, 4)));

    [TestCase(-1, 0)]
    [TestCase(2, 1)]
    [TestCase(int.MaxValue, 1)]
    public void TilesBeyondTheCountAreTheNearestOne(int index, int nearest)
    {
        var layout = new AtlasLayout(1024, 2);
        Assert.That(layout.Tile(index), Is.EqualTo(layout.Tile(nearest)));
    }
}
