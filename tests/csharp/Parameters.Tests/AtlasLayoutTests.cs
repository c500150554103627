namespace Penumbra.Tests;

/// <summary>What is out of range; tests/golden/parameters.json has the rest.</summary>
public class AtlasLayoutTests
{
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
