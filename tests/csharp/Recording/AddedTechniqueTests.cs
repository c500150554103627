namespace Penumbra.Tests;

/// <summary>
/// Techniques of graphs alone: the tests say what the feature records for them, in order, with which targets and sizes.
/// </summary>
public sealed class AddedTechniqueTests : FeatureTests
{
    [SetUp]
    public void SetUp() => Use(AddedTechniques.Options());

    private List<FakeDevice.DrawCall> Draws(FakeScene scene)
    {
        feature.Create();
        urp.Device.Draws.Clear();
        urp.Device.Copies.Clear();
        urp.Render(scene, feature);
        return urp.Device.Draws;
    }

    private static FakeDevice.DrawCall[] Of(IEnumerable<FakeDevice.DrawCall> draws, string pass) =>
        draws.Where(draw => draw.Pass == pass).ToArray();

    private static Vector4 Size(float width, float height) => new Vector4(width, height, 1.0f / width, 1.0f / height);

    private static readonly Rect[] Tiles =
    {
        new Rect(0.0f, 0.0f, 1024.0f, 1024.0f), new Rect(1024.0f, 0.0f, 1024.0f, 1024.0f),
        new Rect(0.0f, 1024.0f, 1024.0f, 1024.0f), new Rect(1024.0f, 1024.0f, 1024.0f, 1024.0f),
    };

    [Test]
    public void AMapIsBlurredTileByTileAndTheFilterFindsIt()
    {
        AddedTechniques.AddMeans();
        List<FakeDevice.DrawCall> draws = Draws(new FakeScene());
        Assert.That(draws.Select(draw => draw.Pass),
                    Is.EqualTo(new[] { "Depths", "Rows", "Columns", "Mips" }
                                   .SelectMany(pass => Enumerable.Repeat(pass, 4)).Append("Resolve")));
        foreach (string pass in new[] { "Depths", "Rows", "Columns" })
        {
            FakeDevice.DrawCall[] of = Of(draws, pass);
            Assert.That(of.Select(draw => draw.Viewport.Value), Is.EqualTo(Tiles), pass);
            Assert.That(of.Select(draw => draw.Uniforms["_PenumbraCascade"]), Is.EqualTo(new[] { 0, 1, 2, 3 }), pass);
            Assert.That(of.Select(draw => Vector(draw, "_PenumbraTile")),
                        Is.EqualTo(Tiles.Select(tile => new Vector4(tile.x, tile.y, tile.width, tile.height))), pass);
            Assert.That(of.Select(draw => Vector(draw, "_PenumbraTargetSize")),
                        Is.All.EqualTo(Size(2048.0f, 2048.0f)), pass);
            Assert.That(of.Select(draw => draw.Target).Distinct().Count(), Is.EqualTo(1), pass);
        }
        string Source(string pass) => Of(draws, pass)[0].Textures["_PenumbraSourceTexture"];
        string Target(string pass) => Of(draws, pass)[0].Target;
        Assert.That((Source("Rows"), Source("Columns")), Is.EqualTo((Target("Depths"), Target("Rows"))));
        Assert.That(Vector(Of(draws, "Rows")[0], "_PenumbraSourceSize"), Is.EqualTo(Size(2048.0f, 2048.0f)));
        FakeDevice.DrawCall resolve = draws.Last();
        Assert.That(resolve.Textures["_PenumbraBlurredTexture"], Is.EqualTo(Target("Columns")));
        Assert.That(Vector(resolve, "_PenumbraBlurredSize"), Is.EqualTo(Size(2048.0f, 2048.0f)));
        Assert.That(resolve.Target, Is.EqualTo("_ScreenSpaceShadowmapTexture"));
        Assert.That(resolve.Viewport, Is.Null);
    }

    /// <summary>No pass reads and writes one texture at once: a level is made from a copy of the one before.</summary>
    [Test]
    public void ALevelIsMadeFromACopyOfTheOneBefore()
    {
        AddedTechniques.AddMeans();
        List<FakeDevice.DrawCall> draws = Draws(new FakeScene());
        string blurred = Of(draws, "Columns")[0].Target;
        FakeDevice.DrawCall[] mips = Of(draws, "Mips");
        string copy = mips[0].Textures["_PenumbraSourceTexture"];
        Assert.That(copy, Is.Not.EqualTo(blurred));
        Assert.That(urp.Device.Copies, Is.EqualTo(new[]
        {
            blurred + " slice 0 mip 0 0 0 2048x2048 to " + copy + " slice 0 mip 0 0 0",
        }));
        Assert.That(mips.Select(draw => draw.Target), Is.All.EqualTo(blurred + " mip 1"));
        Assert.That(mips.Select(draw => draw.Uniforms["_PenumbraMip"]), Is.All.EqualTo(1));
        Assert.That(mips.Select(draw => draw.Viewport.Value.x), Is.EqualTo(new[] { 0.0f, 512.0f, 0.0f, 512.0f }));
        Assert.That(mips.Select(draw => draw.Viewport.Value.width), Is.All.EqualTo(512.0f));
        Assert.That(Vector(mips[0], "_PenumbraTargetSize"), Is.EqualTo(Size(1024.0f, 1024.0f)));
        Assert.That(Vector(mips[0], "_PenumbraSourceSize"), Is.EqualTo(Size(2048.0f, 2048.0f)));
    }

    [Test]
    public void KernelsRunInOrderWithTheirGroups()
    {
        AddedTechniques.AddBlocks();
        // The target has 321 x 181 pixels: 41 x 23 blocks.
        List<FakeDevice.DrawCall> draws = Draws(new FakeScene());
        Assert.That(draws.Select(draw => draw.Pass + ": " + draw.Groups), Is.EqualTo(new[]
        {
            "Mark: 11 6 1", "clear: ", "Collect: 1 1 1", "Sum: 6 3 1", "clear: ", "Shade: 31 1 1",
        }));
        Assert.That(Vector(draws[0], "_PenumbraTargetSize"), Is.EqualTo(Size(41.0f, 23.0f)));
        Assert.That(Vector(draws[3], "_PenumbraTargetSize"), Is.EqualTo(Size(21.0f, 12.0f)));
        Assert.That(Vector(draws[3], "_BeforeSize"), Is.EqualTo(Size(41.0f, 23.0f)));
        Assert.That(Vector(draws[5], "_PenumbraTargetSize"), Is.EqualTo(Size(321.0f, 181.0f)));
        Assert.That(draws[4].Target, Is.EqualTo("_ScreenSpaceShadowmapTexture"), "its groups leave pixels out");
    }

    /// <summary>The visibility is not cleared, and both kernels have the same one.</summary>
    [Test]
    public void AKernelUpdatesWhatAnotherHasFilled()
    {
        AddedTechniques.AddFilledBlocks();
        List<FakeDevice.DrawCall> draws = Draws(new FakeScene());
        Assert.That(draws.Select(draw => draw.Pass + ": " + draw.Groups), Is.EqualTo(new[]
        {
            "Mark: 11 6 1", "clear: ", "Collect: 1 1 1", "Sum: 6 3 1", "Fill: 41 23 1", "Shade: 31 1 1",
        }));
        Assert.That(draws[4].Textures["_Visibility"], Is.EqualTo("_ScreenSpaceShadowmapTexture"));
        Assert.That(draws[5].Textures["_Visibility"], Is.EqualTo("_ScreenSpaceShadowmapTexture"));
    }

    [Test]
    public void KernelsFindTheirTextures()
    {
        AddedTechniques.AddBlocks();
        List<FakeDevice.DrawCall> draws = Draws(new FakeScene());
        FakeDevice.DrawCall mark = draws[0], collect = draws[2], sum = draws[3], shade = draws[5];
        Assert.That(mark.Textures["_Marks"], Is.EqualTo(collect.Textures["_MarksRead"]));
        Assert.That(mark.Textures["_Marks"], Is.EqualTo(sum.Textures["_Before"]));
        Assert.That(sum.Textures["_Sums"], Is.EqualTo(shade.Textures["_Halves"]));
        Assert.That(collect.Textures["_List"], Is.EqualTo(shade.Textures["_Listed"]));
        Assert.That(shade.Textures["_Visibility"], Is.EqualTo("_ScreenSpaceShadowmapTexture"));
        Assert.That(urp.Device.Textures["_ScreenSpaceShadowmapTexture"], Is.EqualTo("_ScreenSpaceShadowmapTexture"));
    }

    [Test]
    public void DynamicResolutionStartsThreadsForWhatIsDrawnAlone()
    {
        AddedTechniques.AddBlocks();
        ScalableBufferManager.widthScaleFactor = ScalableBufferManager.heightScaleFactor = 0.5f;
        List<FakeDevice.DrawCall> draws = Draws(new FakeScene { DynamicResolution = true });
        Assert.That(draws[0].Groups, Is.EqualTo("6 3 1"), "21 x 12 blocks");
    }

    /// <summary>
    /// A draw that is instanced for two eyes would draw into a slice that a texture of the map does not have.
    /// </summary>
    [Test]
    public void PassesOverTheMapDrawOnceForBothEyes()
    {
        const string stereo = "STEREO_INSTANCING_ON";
        AddedTechniques.AddMeans();
        urp.Device.SetKeyword(stereo, true);
        foreach (FakeDevice.DrawCall draw in Draws(new FakeScene { Views = 2 }))
            Assert.That(draw.GlobalKeywords.Contains(stereo), Is.EqualTo(draw.Pass == "Resolve"), draw.Pass);
        Assert.That(urp.Device.Keywords, Has.Member(stereo));
    }

    [Test]
    public void KernelsOverTheScreenAreForBothEyesAtOnceIfTheyDeclareIt()
    {
        ComputeShader kernels = AddedTechniques.AddBlocks();
        ExpectSkipped("kernel 'Mark' uses textures of the screen, and ", new FakeScene { Views = 2 });
        Assert.That(Draws(new FakeScene { Views = 1 }), Is.Not.Empty);
        kernels.KeywordNames.Add("_PENUMBRA_BOTH_EYES");
        Assert.That(Draws(new FakeScene { Views = 2 })[0].Groups, Is.EqualTo("11 6 2"));
    }

    private void ExpectSkipped(string what, FakeScene of = null)
    {
        feature.Create();
        Assert.That(Render(of ?? scene), Is.Empty);
        Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.CascadesName));
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.MissingPass));
        Assert.That(feature.MissingPass, Does.StartWith(what));
        Assert.That(FeatureAdvice.For(FeatureSurroundings.Of(feature)).Select(advice => advice.text),
                    Has.Some.Contains(what));
    }

    [Test]
    public void WithoutItsAssetTheFrameIsUrps()
    {
        AddedTechniques.AddMeans();
        AssetDatabase.Assets.Clear();
        ExpectSkipped("Means.shader is missing");
        AddedTechniques.AddMeans();
        Assert.That(Draws(new FakeScene()), Is.Not.Empty, "it is looked for again");
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.None));
    }

    private static TestCaseData Obstacle(string named, Action place) => new(named, place);

    private static readonly TestCaseData[] Obstacles =
    {
        Obstacle("Means.shader has no pass 'Columns'", () => AddedTechniques.AddMeans().PassNames.Remove("Columns")),
        Obstacle("Means.shader does not compile for this platform", () => AddedTechniques.AddMeans().isSupported = false),
        Obstacle("Blocks.compute is not a compute shader",
                 () =>
                 {
                     AddedTechniques.AddBlocks();
                     AssetDatabase.Assets["Packages/com.penumbra.shadows/Blocks.compute"] = new Shader();
                 }),
        Obstacle("Blocks.compute has no kernel 'Sum', or it does not compile",
                 () => AddedTechniques.AddBlocks().Kernels.RemoveAll(kernel => kernel.Name == "Sum")),
        Obstacle("this device cannot run kernel 'Shade' of Blocks.compute",
                 () => AddedTechniques.AddBlocks().Kernels.Single(kernel => kernel.Name == "Shade").IsSupported = false),
        Obstacle("Blocks.compute is a compute shader, which this device does not support",
                 () => { AddedTechniques.AddBlocks(); SystemInfo.supportsComputeShaders = false; }),
        Obstacle("this device cannot write textures of R32_UInt",
                 () => { AddedTechniques.AddBlocks(); SystemInfo.Unsupported = GraphicsFormat.R32_UInt; }),
        Obstacle("this device cannot draw to textures of R32_SFloat",
                 () => { AddedTechniques.AddMeans(); SystemInfo.Unsupported = GraphicsFormat.R32_SFloat; }),
    };

    [TestCaseSource(nameof(Obstacles))]
    public void WhatIsInTheWayIsNamed(string named, Action place)
    {
        place();
        ExpectSkipped(named);
    }
}
