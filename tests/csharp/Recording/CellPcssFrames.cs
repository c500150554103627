namespace Penumbra.Tests;

/// <summary>Frames of a feature that draws a form of Cell PCSS, and the map's tiles in them.</summary>
public abstract class CellPcssFrames : FeatureTests
{
    // A texel of the first level stands for so many texels of the shadow map, each way.
    protected const int FirstBlock = 4;

    protected abstract ShadowTechnique Technique { get; }

    [SetUp]
    public void SetUp()
    {
        feature.Settings.preset = QualityPreset.Custom;
        feature.Settings.custom.technique = Technique;
    }

    /// <summary>The draws of a pass or kernel, in a frame of its own.</summary>
    private protected FakeDevice.DrawCall[] Calls(string pass)
    {
        Render();
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.None), feature.MissingPass);
        return Draws(pass);
    }

    /// <summary>The tile of each cascade, in texels that stand for `block` of the map each way.</summary>
    protected static IEnumerable<Rect> Tiles(int cascades, int block)
    {
        int side = new AtlasLayout(2048, cascades).TileResolution / block;
        for (int cascade = 0; cascade < cascades; ++cascade)
            yield return new Rect(cascade % 2 * side, cascade / 2 * side, side, side);
    }
}
