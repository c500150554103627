namespace Penumbra.Tests;

/// <summary>
/// Tiled PCSS's passes in a frame: the tests say which part of the map and of the screen each covers, and what is drawn
/// where they cannot run.
/// </summary>
public sealed class TiledPcssTests : FeatureTests
{
    private const string Parameters = "_PenumbraPcssBoundedParameters0";
    private const string BothEyes = "_PENUMBRA_BOTH_EYES";

    [SetUp]
    public void SetUp()
    {
        feature.Settings.preset = QualityPreset.Custom;
        feature.Settings.custom.technique = ShadowTechnique.TiledPcss;
        feature.Settings.custom.halfResolution = false;
        feature.Settings.custom.mask = false;
    }

    // Renders a frame; nothing may be drawn in the technique's place.
    private List<FakeDevice.DrawCall> Drawn()
    {
        Render();
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.None), feature.MissingPass);
        Assert.That(feature.Replaced, Is.Null);
        return urp.Device.Draws;
    }

    private static int GroupsOf(int texels, int side) => (texels + side - 1) / side;

    private static string GroupsOf(int width, int height, int depth, int side) =>
        GroupsOf(width, side) + " " + GroupsOf(height, side) + " " + depth;

    private static Vector4 Size(int width, int height) => new Vector4(width, height, 1.0f / width, 1.0f / height);

    [TestCase(false)]
    [TestCase(true)]
    public void ItsPassesAloneDrawAndTheLastWritesWhatReceiversRead(bool half)
    {
        feature.Settings.custom.halfResolution = half;
        List<FakeDevice.DrawCall> draws = Drawn();
        Assert.That(draws.Select(draw => draw.Pass),
                    Is.EqualTo(TechniqueTable.Graph(half ? "tiled-pcss-half" : "tiled-pcss").passes
                                   .Select(pass => pass.program)));
        Assert.That(draws.Last().Pass, Is.EqualTo(half ? "Upsample" : "SmoothFar"));
        Assert.That(draws.Last().Textures["_PenumbraVisibility"],
                    Is.EqualTo(urp.Device.Textures[ShadowChain.OutputName]));
        Assert.That(draws.Count(draw => draw.Textures.ContainsKey("_PenumbraVisibility")), Is.EqualTo(1));
    }

    // A thread makes the bounds of 8 x 8 texels of the map, and a group has 8 x 8 threads.
    [Test]
    public void BoundsAreMadeOfTheWholeMapAtOnce([Values(1, 2, 3, 4)] int cascades, [Values(0, 2)] int views)
    {
        scene.Cascades = cascades;
        scene.Views = views;
        Drawn();
        FakeDevice.DrawCall bounds = Draw("Bounds");
        var layout = new AtlasLayout(2048, cascades);
        Assert.That(bounds.Groups, Is.EqualTo(GroupsOf(layout.Width, layout.Height, 1, 64)), "one map for both eyes");
        string[] targets = { "Slopes4", "Depths4", "Slopes16", "Depths16", "Slopes64", "Depths64" };
        FakeDevice.DrawCall decide = Draw("DecideTiles");
        foreach (string target in targets)
            Assert.That(decide.Textures["_Penumbra" + target],
                        Is.EqualTo(bounds.Textures["_Penumbra" + target + "Target"]), target);
        Assert.That(targets.Select(target => bounds.Textures["_Penumbra" + target + "Target"]), Is.Unique);
    }

    // With a render scale, a part of the textures is drawn. A thread of DecideTiles has 2 x 2 pixels, of others one.
    [Test]
    public void KernelsCoverThePartOfTheScreenThatIsDrawn([Values(1, 321, 1920)] int width, [Values(1.0f, 0.7f)] float scale,
                                                          [Values] bool half, [Values(0, 2)] int views)
    {
        int height = (9 * width + 15) / 16;
        scene.Width = width;
        scene.Height = height;
        scene.Views = views;
        scene.DynamicResolution = scale < 1.0f;
        ScalableBufferManager.widthScaleFactor = ScalableBufferManager.heightScaleFactor = scale;
        feature.Settings.custom.halfResolution = half;
        foreach (FakeDevice.DrawCall draw in Drawn())
        {
            Assert.That(draw.Keywords.Contains(BothEyes), Is.EqualTo(views == 2), draw.Pass);
            if (draw.Pass == "Bounds") continue;
            int divisor = half && draw.Pass != "Upsample" ? 2 : 1;
            int drawnWidth = Mathf.CeilToInt(GroupsOf(width, divisor) * scale);
            int drawnHeight = Mathf.CeilToInt(GroupsOf(height, divisor) * scale);
            Assert.That(draw.Groups, Is.EqualTo(GroupsOf(drawnWidth, drawnHeight, Math.Max(views, 1),
                                                         draw.Pass == "DecideTiles" ? 16 : 8)), draw.Pass);
            Assert.That(Vector(draw, "_PenumbraTargetSize"), Is.EqualTo(Size(drawnWidth, drawnHeight)), draw.Pass);
            Assert.That(Vector(draw, "_PenumbraScreenSize"),
                        Is.EqualTo(Size(Mathf.CeilToInt(width * scale), Mathf.CeilToInt(height * scale))), draw.Pass);
        }
    }

    /// <summary>
    /// A kernel cannot write to several samples; the camera's target of FakeScene has four. Each eye has a slice of
    /// the screen's textures in the camera's layout.
    /// </summary>
    [Test]
    public void KernelsWriteTexturesOfOneSample([Values] bool half, [Values(1, 2)] int views)
    {
        scene.Views = views;
        feature.Settings.custom.halfResolution = half;
        RenderTextureDescriptor target = scene.Target();
        Assert.That(target.msaaSamples, Is.GreaterThan(1));
        ShadowFrame frame = default;
        frame.layout = new AtlasLayout(2048, 4);
        frame.views = views;
        UrpFrame.SetSize(ref frame, target);
        ShadowChain chain = ShadowChain.Of(feature.Settings.Options());
        foreach (ChainTexture slot in chain.Slots)
        {
            RenderTextureDescriptor texture = UrpFrame.Texture(target, slot, frame);
            Assert.That((texture.msaaSamples, texture.bindMS, texture.enableRandomWrite), Is.EqualTo((1, false, true)));
            Assert.That(texture.graphicsFormat, Is.EqualTo(slot.format));
            if (slot.extent == GraphExtent.Screen)
                Assert.That((texture.dimension, texture.volumeDepth), Is.EqualTo((target.dimension, views)));
            else Assert.That((texture.dimension, texture.volumeDepth), Is.EqualTo((TextureDimension.Tex2D, 1)));
        }
        Assert.That(chain.Slots.Select(slot => slot.format).Distinct(),
                    Is.EqualTo(new[] { GraphicsFormat.R32_SFloat, GraphicsFormat.R32_UInt }), "any device writes these");
    }

    /// <summary>Forward shaders may have the same filter.</summary>
    [TestCase(ShadowTechnique.TiledPcss, false)]
    [TestCase(ShadowTechnique.TiledPcss, true)]
    [TestCase(ShadowTechnique.PcssBounded, false)]
    public void TheOptionsAreToldToEachPassAndStayForForwardShaders(ShadowTechnique technique, bool half)
    {
        feature.Settings.custom.technique = technique;
        feature.Settings.custom.halfResolution = half;
        feature.Settings.custom.blockerSamples = 100;
        feature.Settings.custom.filterSamples = 7;
        feature.Settings.custom.softnessCapMetres = 3.0f;
        var told = new Vector4(100.0f, 7.0f, 3.0f, 0.0f);
        foreach (FakeDevice.DrawCall draw in Drawn()) Assert.That(Vector(draw, Parameters), Is.EqualTo(told), draw.Pass);
        Assert.That(urp.Device.Uniforms[Parameters], Is.EqualTo(told));
    }

    private void ExpectInstead(ShadowTechnique drawn, string keyword, string reason)
    {
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve" }));
        Assert.That(Draw("Resolve").Keywords, Is.EqualTo(new[] { keyword }));
        Assert.That(feature.Replaced, Does.Contain(reason));
        Assert.That(feature.Drawn.technique, Is.EqualTo(drawn));
    }

    private static readonly object[] Lacks =
    {
        Lack("OpenGL does not define", () => SystemInfo.Device = GraphicsDeviceType.OpenGLES3),
        Lack("is a compute shader, which this device does not support", () => SystemInfo.supportsComputeShaders = false),
        Lack("cannot write textures of R32_UInt", () => SystemInfo.Unsupported = GraphicsFormat.R32_UInt),
        Lack("kernel 'Bounds' has groups of 64 threads, and this device allows 32",
             () => SystemInfo.maxComputeWorkGroupSize = 32),
    };

    private static TestCaseData Lack(string reason, Action lack) => new TestCaseData(reason, lack).SetArgDisplayNames(reason);

    [TestCaseSource(nameof(Lacks))]
    public void WithoutWhatKernelsNeedItsFilterIsDrawnAlone(string reason, Action lack)
    {
        lack();
        ExpectInstead(ShadowTechnique.PcssBounded, "_PENUMBRA_PCSS_BOUNDED", reason);
    }

    [Test]
    public void GroupsOf64ThreadsAreEnough()
    {
        SystemInfo.maxComputeWorkGroupSize = 64;
        Assert.That(Drawn().Last().Pass, Is.EqualTo("SmoothFar"));
    }

    [TestCase(ShadowTechnique.TiledPcss)]
    [TestCase(ShadowTechnique.PcssBounded)]
    public void BelowTarget45ATentIsDrawn(ShadowTechnique technique)
    {
        SystemInfo.graphicsShaderLevel = 35;
        feature.Settings.custom.technique = technique;
        ExpectInstead(ShadowTechnique.Tent7x7, "_PENUMBRA_TENT_7X7", "shader model 4.5");
    }

    [Test]
    public void TheFilterAloneNeedsNoKernelsAndDrawsBothEyes()
    {
        feature.Settings.custom.technique = ShadowTechnique.PcssBounded;
        scene.Views = 2;
        SystemInfo.supportsComputeShaders = false;
        FakeDevice.DrawCall resolve = Drawn().Single();
        Assert.That(resolve.Pass, Is.EqualTo("Resolve"));
        Assert.That(resolve.Keywords, Is.EquivalentTo(new[] { "_PENUMBRA_PCSS_BOUNDED", BothEyes }));
    }
}
