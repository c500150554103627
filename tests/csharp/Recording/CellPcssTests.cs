namespace Penumbra.Tests;

/// <summary>Cell PCSS's passes in a frame: the tests say which part of the map and of the screen each covers.</summary>
public sealed class CellPcssTests : CellPcssFrames
{
    // A texel of the coarse levels stands for 8 x 8 texels of the map; a tile has 16 x 16 pixels.
    private const int CoarseBlock = 8;
    private const int TilePixels = 16;
    // A group of ClassifyTiles has so many pixels along each axis.
    private const int GroupPixels = 32;
    private const int WordsOfTile = 17;

    protected override ShadowTechnique Technique => ShadowTechnique.CellPcss;

    // The calls of a kernel; nothing may be drawn in Cell PCSS's place.
    private new FakeDevice.DrawCall[] Calls(string kernel)
    {
        FakeDevice.DrawCall[] calls = base.Calls(kernel);
        Assert.That(feature.Replaced, Is.Null);
        return calls;
    }

    private static Rect Tile(FakeDevice.DrawCall call)
    {
        var tile = (Vector4)call.Uniforms["_PenumbraTile"];
        return new Rect(tile.x, tile.y, tile.z, tile.w);
    }

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3)]
    [TestCase(4)]
    public void TheFirstLevelsAreMadeInTheTileOfEachCascade(int cascades)
    {
        scene.Cascades = cascades;
        FakeDevice.DrawCall[] calls = Calls("FirstLevels");
        Assert.That(calls.Select(Tile), Is.EqualTo(Tiles(cascades, FirstBlock)));
        Assert.That(calls.Select(call => call.Uniforms["_PenumbraCascade"]), Is.EqualTo(Enumerable.Range(0, cascades)));
        ComputeShader.Kernel kernel = FakeShader.CellPcss.Kernels.Single(one => one.Name == "FirstLevels");
        int side = (int)Tiles(cascades, FirstBlock).First().width;
        Assert.That(calls.Select(call => call.Groups),
                    Is.All.EqualTo(side / kernel.X + " " + side / kernel.Y + " 1"), "one thread per texel");
        foreach (FakeDevice.DrawCall call in calls)
            Assert.That(call.Textures.Where(texture => texture.Key.EndsWith("Target")).Select(texture => texture.Value)
                            .Distinct().Count(), Is.EqualTo(4));
    }

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3)]
    [TestCase(4)]
    public void CoarserLevelsAreMadeOfTheWholeMapAtOnce(int cascades)
    {
        scene.Cascades = cascades;
        FakeDevice.DrawCall[] calls = Calls("NextLevel");
        ComputeShader.Kernel kernel = FakeShader.CellPcss.Kernels.Single(one => one.Name == "NextLevel");
        Rect[] tiles = Tiles(cascades, CoarseBlock).ToArray();
        int width = (int)tiles.Max(tile => tile.x + tile.width);
        int height = (int)tiles.Max(tile => tile.y + tile.height);
        var expected = new List<(int, string)>();
        for (int level = 1; Mathf.Max(width, height) >> level >= 1; ++level)
            expected.Add((level, GroupsOf(width >> level, (int)kernel.X) + " " + GroupsOf(height >> level, (int)kernel.Y) + " 1"));
        Assert.That(calls.Select(call => ((int)call.Uniforms["_PenumbraMip"], call.Groups)), Is.EqualTo(expected));
        foreach (FakeDevice.DrawCall call in calls)
            foreach (string map in new[] { "_PenumbraCoarseSpread", "_PenumbraCoarseDepthPlane" })
            {
                string target = call.Textures[map + "Target"];
                Assert.That(target, Does.EndWith(" mip " + call.Uniforms["_PenumbraMip"]));
                Assert.That(call.Textures[map + "s"], Is.Not.EqualTo(target.Split(" mip ")[0]), "a copy of the level before");
            }
    }

    private static int Tiles(int pixels) => (pixels + TilePixels - 1) / TilePixels;
    private static int GroupsOf(int pixels) => GroupsOf(pixels, GroupPixels);
    private static int GroupsOf(int texels, int side) => (Mathf.Max(texels, 1) + side - 1) / side;

    // With a render scale, the camera's target has another size.
    [TestCase(321, 181, 1.0f)]
    [TestCase(160, 90, 1.0f)]
    [TestCase(1920, 1080, 1.0f)]
    [TestCase(1, 1, 1.0f)]
    [TestCase(321, 181, 0.7f)]
    [TestCase(1920, 1080, 0.5f)]
    public void TilesCoverThePartOfTheScreenThatIsDrawn(int width, int height, float scale)
    {
        scene.Width = width;
        scene.Height = height;
        scene.DynamicResolution = scale < 1.0f;
        ScalableBufferManager.widthScaleFactor = ScalableBufferManager.heightScaleFactor = scale;
        int drawnWidth = Mathf.CeilToInt(width * scale);
        int drawnHeight = Mathf.CeilToInt(height * scale);
        FakeDevice.DrawCall classify = Calls("ClassifyTiles").Single();
        Assert.That(classify.Groups, Is.EqualTo(GroupsOf(drawnWidth) + " " + GroupsOf(drawnHeight) + " 1"));
        foreach (string size in new[] { "_PenumbraScreenSize", "_PenumbraTargetSize" })
            Assert.That(classify.Uniforms[size],
                        Is.EqualTo(new Vector4(drawnWidth, drawnHeight, 1.0f / drawnWidth, 1.0f / drawnHeight)), size);
        int words = WordsOfTile * Tiles(width) * Tiles(height);
        Assert.That(classify.Textures["_PenumbraTileList"], Does.EndWith(" of " + words + " x 4"));
    }

    // Kernels write every second pixel; the feature's own pass makes the screen of it.
    [TestCase(321, 181)]
    [TestCase(1920, 1080)]
    [TestCase(1, 1)]
    public void AtHalfResolutionTilesCoverHalfOfTheScreen(int width, int height)
    {
        scene.Width = width;
        scene.Height = height;
        feature.Settings.custom.halfResolution = true;
        FakeDevice.DrawCall classify = Calls("ClassifyTiles").Single();
        int halfWidth = (width + 1) / 2;
        int halfHeight = (height + 1) / 2;
        Assert.That(classify.Groups, Is.EqualTo(GroupsOf(halfWidth) + " " + GroupsOf(halfHeight) + " 1"));
        Assert.That(classify.Keywords.Intersect(FakeShader.CellPcss.KeywordNames), Is.Empty, "the sizes tell it");
        Assert.That(((Vector4)classify.Uniforms["_PenumbraScreenSize"]).x, Is.EqualTo(width));
        Assert.That(((Vector4)classify.Uniforms["_PenumbraTargetSize"]).x, Is.EqualTo(halfWidth));
        int words = WordsOfTile * Tiles(halfWidth) * Tiles(halfHeight);
        Assert.That(classify.Textures["_PenumbraTileList"], Does.EndWith(" of " + words + " x 4"));
        FakeDevice.DrawCall upsampling = urp.Device.Draws.Single(draw => draw.Pass == "Resolve");
        Assert.That(classify.Textures["_PenumbraVisibility"], Does.StartWith(upsampling.Textures["_PenumbraSourceTexture"]));
        Assert.That(upsampling.Uniforms["_PenumbraSourceSize"], Is.EqualTo(classify.Uniforms["_PenumbraTargetSize"]));
        Assert.That(upsampling.Uniforms["_PenumbraMaskSize"], Is.EqualTo(Vector4.zero));
    }

    // Each eye is a slice of the screen's textures and of the groups, and has room of its own in the lists.
    [TestCase(false)]
    [TestCase(true)]
    public void BothEyesAreDrawnAtOnce(bool half)
    {
        scene.Width = 321;
        scene.Height = 181;
        scene.Views = 2;
        feature.Settings.custom.halfResolution = half;
        FakeDevice.DrawCall classify = Calls("ClassifyTiles").Single();
        int width = half ? 161 : 321;
        int height = half ? 91 : 181;
        Assert.That(classify.Groups, Is.EqualTo(GroupsOf(width) + " " + GroupsOf(height) + " 2"));
        Assert.That(classify.Keywords, Has.Member("_PENUMBRA_BOTH_EYES"));
        int words = 2 * WordsOfTile * Tiles(width) * Tiles(height);
        Assert.That(classify.Textures["_PenumbraTileList"], Does.EndWith(" of " + words + " x 4"));
        Assert.That(urp.Device.Draws.Where(draw => draw.Pass == "FirstLevels").Select(draw => draw.Groups.Split(' ')[2]),
                    Is.All.EqualTo("1"), "the map is the same for both");
    }

    [Test]
    public void BothEyesHaveASliceThatKernelsWrite()
    {
        scene.Views = 2;
        RenderTextureDescriptor target = scene.Target();
        ShadowFrame frame = default;
        frame.layout = new AtlasLayout(2048, 4);
        frame.views = 2;
        UrpFrame.SetSize(ref frame, target);
        ShadowChain chain = ShadowChain.Of(feature.Settings.Options());
        RenderTextureDescriptor visibility = UrpFrame.Texture(target, chain.Slots[ShadowChain.Output], frame);
        Assert.That((visibility.dimension, visibility.volumeDepth, visibility.enableRandomWrite),
                    Is.EqualTo((target.dimension, 2, true)), "the camera's layout of eyes");
    }

    [Test]
    public void OneEyeHasNoSlices() =>
        Assert.That(Calls("ClassifyTiles").Single().Keywords, Has.None.EqualTo("_PENUMBRA_BOTH_EYES"));

    [Test]
    public void AtFullResolutionNothingIsUpsampled()
    {
        Dictionary<string, object> uniforms = Calls("ClassifyTiles").Single().Uniforms;
        Assert.That(uniforms["_PenumbraTargetSize"], Is.EqualTo(uniforms["_PenumbraScreenSize"]));
        Assert.That(urp.Device.Draws.Select(draw => draw.Pass), Has.None.EqualTo("Resolve"));
    }

    [TestCase("ResolveTiles", "ClassifyTiles", "_PenumbraTile")]
    [TestCase("ResolveRest", "ResolveTiles", "_PenumbraRest")]
    [TestCase("ResolveAlone", "ResolveTiles", "_PenumbraRest")]
    public void ListedTilesAloneAreResolvedInTheTextureThatReceiversRead(string kernel, string lister, string list)
    {
        FakeDevice.DrawCall resolve = Calls(kernel).Single();
        FakeDevice.DrawCall classify = urp.Device.Draws.Single(draw => draw.Pass == lister);
        Assert.That(resolve.Groups, Is.EqualTo("as " + classify.Textures[list + "Groups"] + " at 0"));
        Assert.That(resolve.Groups, Does.Contain("Raw, IndirectArguments"));
        Assert.That(resolve.Textures[list + "List"], Is.EqualTo(classify.Textures[list + "List"]));
        Assert.That(resolve.Textures["_PenumbraVisibility"], Is.EqualTo(classify.Textures["_PenumbraVisibility"]));
        Assert.That(resolve.Textures["_PenumbraVisibility"],
                    Is.EqualTo(urp.Device.Textures[ShadowChain.OutputName] + " mip 0"));
    }

    /// <summary>A kernel cannot write to several samples; the camera's target of FakeScene has four.</summary>
    [Test]
    public void KernelsWriteTexturesOfOneSample()
    {
        RenderTextureDescriptor target = scene.Target();
        Assert.That(target.msaaSamples, Is.GreaterThan(1));
        ShadowFrame frame = default;
        frame.layout = new AtlasLayout(2048, 4);
        UrpFrame.SetSize(ref frame, target);
        ShadowChain chain = ShadowChain.Of(feature.Settings.Options());
        foreach (ChainTexture slot in chain.Slots)
        {
            RenderTextureDescriptor texture = UrpFrame.Texture(target, slot, frame);
            Assert.That((texture.msaaSamples, texture.bindMS), Is.EqualTo((1, false)));
            Assert.That(texture.enableRandomWrite);
            Assert.That(texture.graphicsFormat, Is.EqualTo(slot.format));
        }
        Assert.That(chain.Slots[ShadowChain.Output].format, Is.EqualTo(GraphicsFormat.R32_SFloat),
                    "undecided pixels are below 0");
    }
}
