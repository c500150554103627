namespace Penumbra.Tests;

/// <summary>The pipeline is asked for these textures of a chain.</summary>
public sealed class ChainTextureTests
{
    private static RenderTextureDescriptor Target()
    {
        RenderTextureDescriptor target = new FakeScene { Views = 2, DynamicResolution = true }.Target();
        target.dimension = TextureDimension.Tex2DArray;
        target.vrUsage = VRTextureUsage.TwoEyes;
        return target;
    }

    private static RenderTextureDescriptor Of(in GraphTexture texture, bool randomWrite = false)
    {
        ShadowFrame frame = default;
        frame.layout = new AtlasLayout(2048, 4);
        UrpFrame.SetSize(ref frame, Target());
        return UrpFrame.Texture(Target(), new ChainTexture(texture, randomWrite, kept: false), frame);
    }

    private static GraphTexture Texture(GraphExtent extent, int divisor = 1, int mips = 1, int layers = 1,
                                        int samples = 1, int depth = 1) =>
        new GraphTexture("t", extent, GraphicsFormat.R32_SFloat, divisor, width: 64, height: 32, depth: depth,
                         mips: mips, layers: layers, samples: samples);

    [Test]
    public void AMapsTextureIsTheSameForBothEyes()
    {
        RenderTextureDescriptor ofMap = Of(Texture(GraphExtent.Map, 4), randomWrite: true);
        Assert.That((ofMap.width, ofMap.height, ofMap.volumeDepth), Is.EqualTo((512, 512, 1)));
        Assert.That((ofMap.dimension, ofMap.vrUsage), Is.EqualTo((TextureDimension.Tex2D, VRTextureUsage.None)));
        Assert.That(ofMap.useDynamicScale, Is.False);
        Assert.That(ofMap.enableRandomWrite);
        Assert.That(ofMap.graphicsFormat, Is.EqualTo(GraphicsFormat.R32_SFloat));
    }

    [Test]
    public void AScreensTextureHasBothEyes()
    {
        RenderTextureDescriptor ofScreen = Of(Texture(GraphExtent.Screen, 2));
        Assert.That((ofScreen.width, ofScreen.height, ofScreen.volumeDepth), Is.EqualTo((161, 91, 2)));
        Assert.That((ofScreen.dimension, ofScreen.vrUsage),
                    Is.EqualTo((TextureDimension.Tex2DArray, VRTextureUsage.TwoEyes)));
        Assert.That(ofScreen.useDynamicScale);
        Assert.That(ofScreen.enableRandomWrite, Is.False);
        Assert.That((ofScreen.useMipMap, ofScreen.bindMS, ofScreen.msaaSamples), Is.EqualTo((false, false, 1)));
    }

    [TestCase(GraphExtent.Tile, 1, 1, TextureDimension.Tex2DArray, 4)]
    [TestCase(GraphExtent.Fixed, 1, 1, TextureDimension.Tex2D, 1)]
    [TestCase(GraphExtent.Fixed, 6, 1, TextureDimension.Tex2DArray, 6)]
    [TestCase(GraphExtent.Fixed, 1, 16, TextureDimension.Tex3D, 16)]
    [TestCase(GraphExtent.Screen, 3, 1, TextureDimension.Tex2DArray, 3)]
    public void LayersAndDepthAreSlices(object extent, int layers, int depth, object dimension, int slices)
    {
        RenderTextureDescriptor texture = Of(Texture((GraphExtent)extent, layers: layers, depth: depth));
        Assert.That((texture.dimension, texture.volumeDepth), Is.EqualTo(((TextureDimension)dimension, slices)));
        Assert.That(texture.vrUsage, Is.EqualTo(VRTextureUsage.None));
    }

    [Test]
    public void LevelsAreMadeByPasses()
    {
        RenderTextureDescriptor texture = Of(Texture(GraphExtent.Map, mips: 0));
        Assert.That((texture.useMipMap, texture.autoGenerateMips), Is.EqualTo((true, false)));
    }

    [Test]
    public void SamplesAreReadOneByOne()
    {
        RenderTextureDescriptor texture = Of(Texture(GraphExtent.Screen, samples: 4));
        Assert.That((texture.msaaSamples, texture.bindMS), Is.EqualTo((4, true)));
    }
}
