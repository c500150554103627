namespace Penumbra.Tests;

/// <summary>
/// Chains keep textures of a camera from frame to frame; the tests say which, and what is drawn for them.
/// </summary>
public sealed class CameraStoreTests : EngineTests
{
    private CameraStores stores;
    private ChainDraw draw;
    private FakeDevice device;
    private Camera camera;
    private ShadowFrame frame;

    [SetUp]
    public void SetUp()
    {
        FakeShader.Install();
        stores = new CameraStores();
        device = new FakeDevice();
        camera = new Camera();
        frame = default;
        frame.options = AddedTechniques.Options();
        frame.layout = new AtlasLayout(2048, 4);
        frame.uniforms = new ShadowUniforms(frame.options.Parameters(), frame.layout, 0);
        frame.views = 1;
    }

    [TearDown]
    public void TearDown() => stores.Dispose();

    private void Prepare()
    {
        var assets = new PassAssets();
        assets.Find(ChainGraphs.All);
        draw = new ChainDraw(new Material(FakeShader.Install()), assets);
        Assert.That(draw.Prepare(ref frame.options, 1), Is.Null);
        lent = draw.Chain.Slots.Select((slot, i) => new RTHandle { What = draw.Chain.SlotNames[i] }).ToArray();
    }

    private RTHandle[] lent;
    private readonly CommandBuffer commands = new CommandBuffer();

    // The steps are those of both recorders, but for the textures that the pipeline lends.
    private void Record(in RenderTextureDescriptor target)
    {
        UrpFrame.SetSize(ref frame, target);
        draw.Prepare(ref frame.options, 1);
        CameraStore store = stores.Of(camera, 0);
        store.Prepare(draw.Chain, target, ref frame);
        for (int i = 0; i < lent.Length; ++i)
            if (draw.Chain.Slots[i].IsOwned) lent[i] = store.Textures[i];
        draw.Draw(commands, frame, lent);
        store.SetFilled(frame);
    }

    private string[] Draws(int updated, int width = 321)
    {
        frame.updatedCascades = updated;
        commands.Clear();
        Record(new FakeScene { Width = width }.Target());
        device.Draws.Clear();
        device.Copies.Clear();
        device.Play(commands);
        return device.Draws.Select(call => call.Pass).ToArray();
    }

    [Test]
    public void OnlyCascadesThatWereDrawnAnewAreDrawnAgain()
    {
        AddedTechniques.AddMeans();
        Prepare();
        Assert.That(Draws(0).Length, Is.EqualTo(4 * 4 + 1), "nothing is there yet");
        Assert.That(Draws(0b0100), Is.EqualTo(new[] { "Depths", "Rows", "Columns", "Mips", "Resolve" }));
        Assert.That(device.Draws.Take(4).Select(call => call.Uniforms["_PenumbraCascade"]), Is.All.EqualTo(2));
        Assert.That(device.Draws[0].Viewport, Is.EqualTo(new Rect(0.0f, 1024.0f, 1024.0f, 1024.0f)));
        Assert.That(Draws(0), Is.EqualTo(new[] { "Resolve" }));
        Assert.That(device.Copies, Is.Empty, "no level is made");
        Assert.That(Draws(0b1111).Length, Is.EqualTo(4 * 4 + 1));
    }

    [Test]
    public void TheOtherTilesOfATargetStay()
    {
        AddedTechniques.AddMeans();
        Prepare();
        Draws(0b0001);
        Assert.That(device.Draws.Where(call => call.Pass != "Resolve").Select(call => call.Load),
                    Is.All.EqualTo(RenderBufferLoadAction.Load));
        Assert.That(device.Draws.Last().Load, Is.EqualTo(RenderBufferLoadAction.DontCare));
    }

    private static IEnumerable<ShadowTechnique> WithMaps() =>
        Enum.GetValues(typeof(ShadowTechnique)).Cast<ShadowTechnique>()
            .Where(technique => technique.Entry().formats[0].graph?.passes.Any(
                       pass => pass.runs == PassFrequency.Cascade) == true);

    [TestCaseSource(nameof(WithMaps))]
    public void MapsOfATechniqueAreMadeForCascadesThatWereDrawnAnew(ShadowTechnique technique)
    {
        frame.options.technique = technique;
        Prepare();
        IEnumerable<string> ofMaps = technique.Entry().formats[0].graph.passes.Select(pass => pass.program);
        int all = Draws(0).Length;
        Assert.That(Draws(0), Is.EqualTo(new[] { "Resolve" }));
        string[] one = Draws(0b0100);
        Assert.That(one.Distinct(), Is.EqualTo(ofMaps.Append("Resolve")));
        Assert.That(4 * (one.Length - 1), Is.EqualTo(all - 1));
        Assert.That(device.Draws.SkipLast(1).Select(call => call.Uniforms["_PenumbraCascade"]), Is.All.EqualTo(2));
    }

    [TestCaseSource(nameof(WithMaps))]
    public void MapsOfATechniqueAreGivenBackWithIt(ShadowTechnique technique)
    {
        frame.options.technique = technique;
        Prepare();
        Draws(0);
        RTHandle[] maps = stores.Of(camera, 0).Textures.Where(texture => texture != null).ToArray();
        Assert.That(maps, Is.Not.Empty);
        frame.options.technique = ShadowTechnique.Pcss;
        Prepare();
        Draws(0);
        Assert.That(maps.All(map => map.Released));
        Assert.That(stores.Of(camera, 0).Textures, Is.All.Null);
    }

    [Test]
    public void EveryCameraHasItsOwn()
    {
        AddedTechniques.AddMeans();
        Prepare();
        Draws(0);
        RTHandle first = stores.Of(camera, 0).Textures.Single(texture => texture != null);
        camera = new Camera();
        Assert.That(Draws(0).Length, Is.EqualTo(4 * 4 + 1));
        Assert.That(stores.Of(camera, 0).Textures.Single(texture => texture != null), Is.Not.SameAs(first));
        Assert.That(first.Released, Is.False);
    }

    [Test]
    public void ACameraThatDrawsNoMoreGivesItsOwnBack()
    {
        AddedTechniques.AddMeans();
        Prepare();
        Draws(0);
        RTHandle[] textures = stores.Of(camera, 0).Textures.Where(texture => texture != null).ToArray();
        Assert.That(textures, Is.Not.Empty);
        camera = new Camera();
        for (Time.frameCount = 1; Time.frameCount <= CameraStores.IdleFrames; ++Time.frameCount)
        {
            Assert.That(textures.Any(texture => texture.Released), Is.False, "frame " + Time.frameCount);
            Draws(0);
        }
        Assert.That(textures.All(texture => texture.Released));
    }

    private static GraphPass Pass(string program, PassFrequency runs, int[] targets, params GraphBinding[] reads) =>
        new GraphPass
        {
            asset = PenumbraShadows.ShaderFile, program = program, runs = runs, reads = reads,
            writes = targets.Select(GraphBinding.Texture).ToArray(),
        };

    internal static TechniqueGraph Baked(GraphExtent extent) => new TechniqueGraph
    {
        name = "baked",
        textures = new[]
        {
            new GraphTexture("a", extent, GraphicsFormat.R8_UNorm, width: 64, height: 64),
            new GraphTexture("b", extent, GraphicsFormat.R32_SFloat, width: 64, height: 64),
            new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
        },
        passes = new[]
        {
            Pass("PenumbraMask", PassFrequency.Bake, new[] { 0, 1 }),
            Pass("Resolve", PassFrequency.Frame, new[] { 2 }, GraphBinding.Texture("_A", 0),
                 GraphBinding.Texture("_B", 1)),
        },
        visibility = 2,
    };

    [TestCase(GraphExtent.Screen, true)]
    [TestCase(GraphExtent.Fixed, false)]
    public void WhatIsBakedIsBakedOnceForASize(object extent, bool again)
    {
        AddedTechniques.Use(Baked((GraphExtent)extent));
        Prepare();
        string[] both = { "PenumbraMask", "Resolve" }, one = { "Resolve" };
        Assert.That(Draws(0), Is.EqualTo(both));
        Assert.That(device.Draws[0].Target, Is.EqualTo(draw.Chain.SlotNames[1] + " + " + draw.Chain.SlotNames[2]));
        Assert.That(Draws(0), Is.EqualTo(one));
        Assert.That(Draws(0, width: 500), Is.EqualTo(again ? both : one));
        Assert.That(Draws(0, width: 500), Is.EqualTo(one));
    }

    [Test]
    public void WhatWasNotRecordedIsRecordedTheNextTime()
    {
        AddedTechniques.Use(Baked(GraphExtent.Fixed));
        Prepare();
        CommandBuffer.FailAt = commands.Commands.Count;
        Assert.That(() => Draws(0), Throws.InvalidOperationException);
        CommandBuffer.FailAt = -1;
        Assert.That(Draws(0), Is.EqualTo(new[] { "PenumbraMask", "Resolve" }));
    }

    // The graph computes the mean of this frame and the ones before it.
    internal static TechniqueGraph Mean() => new TechniqueGraph
    {
        name = "mean",
        textures = new[]
        {
            new GraphTexture("before", GraphExtent.Screen, GraphicsFormat.R32_SFloat, previousOf: 1),
            new GraphTexture("mean", GraphExtent.Screen, GraphicsFormat.R32_SFloat),
            new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
        },
        passes = new[]
        {
            Pass("DenoiseHorizontal", PassFrequency.Frame, new[] { 1 }, GraphBinding.Texture("_Before", 0)),
            Pass("Resolve", PassFrequency.Frame, new[] { 2 }, GraphBinding.Texture("_Mean", 1)),
        },
        visibility = 2,
    };

    [Test]
    public void AHistoryIsWhatWasWrittenAFrameAgo()
    {
        AddedTechniques.Use(Mean());
        Prepare();
        Assert.That(Draws(0), Is.EqualTo(new[] { "clear", "DenoiseHorizontal", "Resolve" }));
        Assert.That(device.Draws[0].Target, Is.EqualTo(device.Draws[1].Textures["_Before"]), "nothing was before");
        for (int i = 0; i < 3; ++i)
        {
            string written = device.Draws.Single(call => call.Pass == "DenoiseHorizontal").Target;
            Assert.That(Draws(0), Is.EqualTo(new[] { "DenoiseHorizontal", "Resolve" }));
            Assert.That(device.Draws[0].Textures["_Before"], Is.EqualTo(written));
            Assert.That(device.Draws[0].Target, Is.Not.EqualTo(written));
            Assert.That(device.Draws[1].Textures["_Mean"], Is.EqualTo(device.Draws[0].Target));
        }
        Assert.That(Draws(0, width: 500)[0], Is.EqualTo("clear"), "of another size");
    }

    [Test]
    public void EveryLevelOfAHistoryIsEmptyAtFirst()
    {
        TechniqueGraph mean = Mean();
        for (int i = 0; i < 2; ++i)
            mean.textures[i] = new GraphTexture("t", GraphExtent.Screen, GraphicsFormat.R32_SFloat, mips: 2,
                                                previousOf: i == 0 ? 1 : TechniqueGraph.None);
        AddedTechniques.Use(mean);
        Prepare();
        Draws(0);
        string before = device.Draws.First(call => call.Pass == "DenoiseHorizontal").Textures["_Before"];
        Assert.That(device.Draws.Where(call => call.Pass == "clear").Select(call => call.Target),
                    Is.EqualTo(new[] { before, before + " mip 1" }));
    }

    /// <summary>One camera draws all faces, in one frame.</summary>
    [Test]
    public void TheFaceOfAProbeHasNoHistory()
    {
        AddedTechniques.Use(Mean());
        Prepare();
        frame.isProbe = true;
        for (int face = 0; face < 6; ++face)
            Assert.That(Draws(0), Is.EqualTo(new[] { "clear", "DenoiseHorizontal", "Resolve" }));
    }

    /// <summary>The device puts a scaled texture elsewhere in its memory.</summary>
    [TestCase(true)]
    [TestCase(false)]
    public void AnotherScaleOfDynamicResolutionBeginsAnew(bool keepsScreen)
    {
        AddedTechniques.Use(Baked(keepsScreen ? GraphExtent.Screen : GraphExtent.Fixed));
        Prepare();
        RenderTextureDescriptor target = new FakeScene { DynamicResolution = true }.Target();
        void ExpectEmpty(float scale, bool empty)
        {
            ScalableBufferManager.widthScaleFactor = scale;
            Record(target);
            Assert.That(frame.storeIsEmpty, Is.EqualTo(empty), scale.ToString());
        }
        ExpectEmpty(1.0f, true);
        ExpectEmpty(1.0f, false);
        ExpectEmpty(0.5f, keepsScreen);
        ExpectEmpty(0.5f, false);
    }

    [Test]
    public void WhatTheDeviceHasLostIsMadeAgain()
    {
        AddedTechniques.Use(Baked(GraphExtent.Fixed));
        Prepare();
        Draws(0);
        RenderTexture baked = stores.Of(camera, 0).Textures.First(texture => texture != null).rt;
        baked.Lost = true;
        Assert.That(Draws(0), Is.EqualTo(new[] { "PenumbraMask", "Resolve" }));
        baked.Lost = false;
        Assert.That(Draws(0), Is.EqualTo(new[] { "Resolve" }));
    }

    /// <summary>Three cascades' tiles are as large as four's.</summary>
    [Test]
    public void TilesOfMoreCascadesAreOthers()
    {
        AddedTechniques.Use(Baked(GraphExtent.Tile));
        Prepare();
        frame.layout = new AtlasLayout(2048, 3);
        Draws(0);
        RTHandle ofThree = stores.Of(camera, 0).Textures.First(texture => texture != null);
        frame.layout = new AtlasLayout(2048, 4);
        Assert.That(Draws(0), Is.EqualTo(new[] { "PenumbraMask", "Resolve" }));
        Assert.That(stores.Of(camera, 0).Textures.First(texture => texture != null), Is.Not.SameAs(ofThree));
        Assert.That(ofThree.Released);
    }

    [Test]
    public void EyesThatAreDrawnOneAfterTheOtherHaveTheirOwn() =>
        Assert.That(stores.Of(camera, 1), Is.Not.SameAs(stores.Of(camera, 0)));
}
