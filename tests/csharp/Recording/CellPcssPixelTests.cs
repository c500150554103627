namespace Penumbra.Tests;

/// <summary>
/// Cell PCSS per pixel draws into two maps at once, level by level, which its filter and forward shaders read.
/// Cell PCSS has the same maps.
/// </summary>
public sealed class CellPcssPixelTests : CellPcssFrames
{
    private const int CoarseBlock = 8;  // texels of the shadow map in a texel of the coarse levels, each way
    private static readonly string[] FirstMaps = { "_PenumbraDepthPlanesTexture", "_PenumbraDepthSpreadsTexture" };
    private static readonly string[] CoarseMaps = { "_PenumbraCoarsePlanesTexture", "_PenumbraCoarseSpreadsTexture" };
    private static readonly string[] Maps = FirstMaps.Concat(CoarseMaps).ToArray();
    private static readonly string[] Sources = { "_PenumbraSourcePlanes", "_PenumbraSourceSpreads" };

    protected override ShadowTechnique Technique => ShadowTechnique.CellPcssPixel;

    private static int Levels(int cascades)
    {
        int levels = 1;
        while (Tiles(cascades, CoarseBlock << levels).First().width >= 1.0f) ++levels;
        return levels;
    }

    private string Both(string[] maps) => string.Join(" + ", maps.Select(map => urp.Device.Textures[map]));

    private void ExpectTiles(FakeDevice.DrawCall[] calls, int cascades, int block, string[] maps)
    {
        Assert.That(calls.Select(call => call.Viewport.Value), Is.EqualTo(Tiles(cascades, block)));
        Assert.That(calls.Select(call => call.Uniforms["_PenumbraCascade"]), Is.EqualTo(Enumerable.Range(0, cascades)));
        Assert.That(calls.Select(call => call.Target), Is.All.EqualTo(Both(maps)));
        Assert.That(calls.Select(call => call.Load), Is.All.EqualTo(RenderBufferLoadAction.Load),
                    "the other cascades' tiles are kept");
    }

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3)]
    [TestCase(4)]
    public void TheFirstLevelsAreDrawnInTheTileOfEachCascade(int cascades)
    {
        scene.Cascades = cascades;
        ExpectTiles(Calls("QuarterDepthBlocks"), cascades, FirstBlock, FirstMaps);
        Assert.That(feature.Replaced, Is.Null);
        FakeDevice.DrawCall[] next = Calls("EighthDepthBlocks");
        ExpectTiles(next, cascades, CoarseBlock, CoarseMaps);
        for (int i = 0; i < 2; ++i)
            Assert.That(next.Select(call => call.Textures[Sources[i]]), Is.All.EqualTo(urp.Device.Textures[FirstMaps[i]]));
    }

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3)]
    [TestCase(4)]
    public void EachLevelIsDrawnFromCopiesOfTheOneBefore(int cascades)
    {
        scene.Cascades = cascades;
        FakeDevice.DrawCall[] calls = Calls("DepthBlocksMip");
        var expected = new List<(int, Rect)>();
        for (int level = 1; level < Levels(cascades); ++level)
            expected.AddRange(Tiles(cascades, CoarseBlock << level).Select(tile => (level, tile)));
        Assert.That(calls.Select(call => ((int)call.Uniforms["_PenumbraMip"], call.Viewport.Value)),
                    Is.EqualTo(expected));
        foreach (FakeDevice.DrawCall call in calls)
        {
            int level = (int)call.Uniforms["_PenumbraMip"];
            Assert.That(call.Target, Is.EqualTo(Both(CoarseMaps) + " mip " + level));
            Assert.That(call.Load, Is.EqualTo(RenderBufferLoadAction.Load));
            for (int i = 0; i < 2; ++i)
            {
                string map = urp.Device.Textures[CoarseMaps[i]];
                Assert.That(call.Textures[Sources[i]], Is.Not.EqualTo(map));
                Assert.That(urp.Device.Copies.Count(copy => copy.StartsWith(map + " slice 0 mip " + (level - 1) + " 0 0 ") &&
                                                            copy.EndsWith(" to " + call.Textures[Sources[i]] +
                                                                          " slice 0 mip 0 0 0")),
                            Is.EqualTo(1), map + ", level " + level);
            }
        }
        Assert.That(urp.Device.Copies.Count, Is.EqualTo(2 * (Levels(cascades) - 1)));
    }

    [Test]
    public void TheMapsKeepWhatIsNotDrawnAnewAndAreNoTargetsOfKernels()
    {
        ShadowChain chain = ShadowChain.Of(feature.Settings.Options());
        ChainTexture[] maps = chain.Globals.Select(map => chain.Slots[map.texture.index]).ToArray();
        Assert.That(maps.Select(map => map.format), Is.EqualTo(new[]
        {
            GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.R32G32B32A32_UInt,
            GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.R32G32B32A32_UInt,
        }));
        Assert.That(maps.Select(map => map.kept), Is.All.True);
        Assert.That(maps.Select(map => map.randomWrite || map.filtered), Is.All.False);
        Assert.That(maps.Select(map => map.mips), Is.EqualTo(new[] { 1, 1, 0, 0 }), "0: all levels");
        foreach (ChainTexture slot in chain.Slots.Skip(1).Where(slot => !slot.kept))
            Assert.That(maps.Select(map => map.format), Contains.Item(slot.format), "copies have their map's format");
    }

    /// <summary>Transparents read the maps with the keyword of URP's own map, which is on again by then.</summary>
    [Test]
    public void TheMapsAndParametersStayBoundForForwardShaders()
    {
        feature.Settings.custom.softnessCapMetres = 3.0f;
        feature.Settings.custom.minFilterTexels = 2.0f;
        urp.Render(scene, feature);
        FakeDevice.DrawCall resolve = urp.Device.Draws.Single(draw => draw.Pass == "Resolve");
        Assert.That(resolve.Keywords, Is.EqualTo(new[] { "_PENUMBRA_CELL_PCSS" }));
        foreach (string map in Maps) Assert.That(urp.Device.Textures[map], Is.EqualTo(resolve.Textures[map]), map);
        Assert.That(Maps.Select(map => urp.Device.Textures[map]).Distinct().Count(), Is.EqualTo(4));
        PcssAngularParameters told = new ShadowUniforms(feature.Settings.Options().Parameters(),
                                                        new AtlasLayout(2048, 4), 0).PcssAngular;
        Assert.That((told.maxPenumbraMetres, told.minFilterTexels), Is.EqualTo((3.0f, 2.0f)));
        var expected = new FakeDevice();
        var commands = new CommandBuffer();
        told.SetGlobal(commands);
        expected.Play(commands);
        Assert.That(expected.Uniforms.Count, Is.EqualTo(2));
        foreach (KeyValuePair<string, object> vector in expected.Uniforms)
        {
            Assert.That(resolve.Uniforms[vector.Key], Is.EqualTo(vector.Value), vector.Key);
            Assert.That(urp.Device.Uniforms[vector.Key], Is.EqualTo(vector.Value), vector.Key);
        }
    }

    /// <summary>Cell PCSS's maps, which its kernels have written, serve the same forward shaders.</summary>
    [Test]
    public void MapsOfCellPcssStayBoundForForwardShaders()
    {
        feature.Settings.custom.technique = ShadowTechnique.CellPcss;
        FakeDevice.DrawCall first = Calls("FirstLevels").Last();
        Assert.That(feature.Replaced, Is.Null);
        string[] targets =
        {
            "_PenumbraDepthPlaneTarget", "_PenumbraSpreadTarget", "_PenumbraCoarseDepthPlaneTarget",
            "_PenumbraCoarseSpreadTarget",
        };
        Assert.That(Maps.Select(map => urp.Device.Textures[map] + " mip 0"),
                    Is.EqualTo(targets.Select(target => first.Textures[target])));
    }

    /// <summary>The maps are the light's, one set for both eyes; kernels are not needed.</summary>
    [Test]
    public void BothEyesAndDevicesWithoutKernelsHaveIt()
    {
        scene.Views = 2;
        SystemInfo.supportsComputeShaders = false;
        Assert.That(Calls("QuarterDepthBlocks").Length, Is.EqualTo(4));
        Assert.That(feature.Replaced, Is.Null);
    }

    private void ExpectTent(string reason)
    {
        FakeDevice.DrawCall resolve = Calls("Resolve").Single();
        Assert.That(urp.Device.Draws.Count, Is.EqualTo(1));
        Assert.That(resolve.Keywords, Is.EqualTo(new[] { "_PENUMBRA_TENT_7X7" }));
        Assert.That(feature.Replaced, Does.Contain(reason));
        Assert.That(feature.Drawn.technique, Is.EqualTo(ShadowTechnique.Tent7x7));
    }

    [Test]
    public void OnOpenGlItIsTheTent()
    {
        SystemInfo.Device = GraphicsDeviceType.OpenGLES3;
        ExpectTent("OpenGL does not define");
    }

    [Test]
    public void BelowTarget45ItIsTheTent()
    {
        SystemInfo.graphicsShaderLevel = 35;
        ExpectTent("it needs shader model 4.5");
    }

    [TestCase(GraphicsFormat.R32G32B32A32_UInt)]
    [TestCase(GraphicsFormat.R32G32B32A32_SFloat)]
    public void WithoutEitherFormatItIsTheTent(object format)
    {
        SystemInfo.Unsupported = (GraphicsFormat)format;
        ExpectTent("this device cannot draw to textures of " + format);
    }

    [Test]
    public void WithOneTargetItIsTheTent()
    {
        SystemInfo.supportedRenderTargetCount = 1;
        ExpectTent("pass 'QuarterDepthBlocks' draws to 2 textures at once, and this device supports 1");
    }

    [Test]
    public void WithoutCopiesItIsTheTent()
    {
        SystemInfo.copyTextureSupport = CopyTextureSupport.None;
        ExpectTent("pass 'DepthBlocksMip' generates mip levels from copies");
    }
}
