namespace Penumbra.Tests;

/// <summary>A debug view is the last draw of its camera, over the picture, and changes nothing else.</summary>
public sealed class DebugViewTests : FeatureTests
{
    private static readonly DebugView[] Views =
        Enum.GetValues(typeof(DebugView)).Cast<DebugView>().Where(view => view != DebugView.None).ToArray();

    [SetUp]
    public void SetUp() => PresetFallback.Choose(feature.Settings, QualityPreset.High);

    [TestCase(QualityPreset.Custom)]
    [TestCase(QualityPreset.Low)]
    [TestCase(QualityPreset.High)]
    public void EachIsDrawnOverTheCamerasPictureAfterTheChain(QualityPreset preset)
    {
        feature.Settings.preset = preset;
        string[] chain = Render();
        foreach (DebugView view in Views)
        {
            feature.Settings.debugView = view;
            Assert.That(Render(), Is.EqualTo(chain.Append(view.ToString())));
            FakeDevice.DrawCall draw = urp.Device.Draws.Last();
            Assert.That(draw.Target, Is.EqualTo("_CameraColorTexture"), view.ToString());
            Assert.That(draw.Vertices, Is.EqualTo(3));
            Assert.That(draw.Textures["_ScreenSpaceShadowmapTexture"], Is.EqualTo("_ScreenSpaceShadowmapTexture"));
            Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.ScreenName));
            Assert.That(keywords.AtEnd, Is.EqualTo(ShadowKeywords.CascadesName));
        }
    }

    [Test]
    public void TheShaderHasAPassForEach()
    {
        string shader = File.ReadAllText(
            Path.Combine(FakeShader.PackageRoot(), "Shaders", "PenumbraDebugViews.shader"));
        Assert.That(shader, Does.Contain("\"" + DebugViewDraw.ShaderName + "\""));
        foreach (DebugView view in Views) Assert.That(shader, Does.Contain("Name \"" + view + "\""));
    }

    [Test]
    public void TheMaskIsShownWhereThereIsOne()
    {
        foreach (bool masked in new[] { true, false })
        {
            feature.Settings.custom.mask = masked;
            feature.Settings.debugView = DebugView.PenumbraMask;
            Render();
            FakeDevice.DrawCall draw = urp.Device.Draws.Last();
            Assert.That(Vector(draw, "_PenumbraDebugParams").x, Is.EqualTo(masked ? 1.0f : 0.0f));
            if (!masked) continue;
            FakeDevice.DrawCall mask = urp.Device.Draws.Single(call => call.Pass == "MaskBlurVertical");
            Assert.That(draw.Textures["_PenumbraMaskTexture"], Is.EqualTo(mask.Target));
            Assert.That(urp.Device.Draws.SkipWhile(call => call != mask).Skip(1).Select(call => call.Target),
                        Has.None.EqualTo(mask.Target), "overwritten before it is shown");
        }
    }

    /// <summary>Tiled PCSS's kernels read no mask; the option is there for what is drawn in its place.</summary>
    [Test]
    public void TiledPcssHasNoMaskAndItsFallbackHas()
    {
        feature.Settings.custom.technique = ShadowTechnique.TiledPcss;
        feature.Settings.debugView = DebugView.PenumbraMask;
        foreach (bool kernels in new[] { true, false })
        {
            SystemInfo.supportsComputeShaders = kernels;
            feature.Create();
            Render();
            Assert.That(Vector(urp.Device.Draws.Last(), "_PenumbraDebugParams").x, Is.EqualTo(kernels ? 0.0f : 1.0f));
        }
    }

    [Test]
    public void AnOverlayCameraLeavesWhatItDoesNotSee()
    {
        feature.Settings.debugView = DebugView.Cascades;
        foreach (bool overlay in new[] { false, true })
        {
            urp.Render(new FakeScene { Overlay = overlay }, feature);
            Assert.That(Vector(urp.Device.Draws.Last(), "_PenumbraDebugParams").y, Is.EqualTo(overlay ? 1.0f : 0.0f));
        }
    }

    [Test]
    public void AVolumeChoosesOneByPlace()
    {
        PenumbraShadowsVolume volume = Volume(QualityPreset.Medium);
        volume.debugView.Set(DebugView.Cascades);
        Assert.That(Render().Last(), Is.EqualTo("Cascades"));
        volume.debugView.overrideState = false;
        feature.Settings.debugView = DebugView.ShadowTexels;
        Assert.That(Render().Last(), Is.EqualTo("ShadowTexels"));
    }

    [Test]
    public void AReleasePlayerDrawsNone()
    {
        feature.Settings.debugView = DebugView.Cascades;
        Debug.isDebugBuild = false;
        Assert.That(Render().Last(), Is.EqualTo("Resolve"));
    }

    [Test]
    public void WithoutItsShaderTheFrameGoesOn()
    {
        feature.Dispose();
        Shader.Known.Remove(DebugViewDraw.ShaderName);
        feature = new PenumbraShadows();
        feature.Create();
        PresetFallback.Choose(feature.Settings, QualityPreset.High);
        feature.Settings.debugView = DebugView.Cascades;
        Assert.That(Render().Last(), Is.EqualTo("Resolve"));
        Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.ScreenName));
    }

    [Test]
    public void ACameraThatIsLeftToUrpOrHasNoPictureShowsNone()
    {
        feature.Settings.debugView = DebugView.Visibility;
        foreach (FakeScene every in FakeScene.Every())
        {
            bool drawn = Render(every).Contains("Resolve");
            Assert.That(Passes().Contains("Visibility"), Is.EqualTo(drawn), scene.ToString());
        }
    }

    [Test]
    public void ThePictureIsATextureOrItsRowsAreAskedFor()
    {
        feature.Settings.debugView = DebugView.Visibility;
        var renderer = new QueueOfPasses();
        RenderingData data = FakeUrp.Data(new FakeScene(), new Camera());
        feature.AddRenderPasses(renderer, ref data);
        ScriptableRenderPass last = renderer.Queue.OrderBy(pass => (int)pass.renderPassEvent).Last();
#if UNITY_6000_5_OR_NEWER
        Assert.That(last.renderPassEvent, Is.EqualTo(RenderPassEvent.AfterRenderingTransparents));
        Assert.That(last.requiresIntermediateTexture, Is.False, "it asks which way the rows run");
#elif UNITY_6000_0_OR_NEWER
        Assert.That(last.renderPassEvent, Is.EqualTo(RenderPassEvent.AfterRenderingTransparents));
        Assert.That(last.requiresIntermediateTexture);
#else
        Assert.That(last.renderPassEvent, Is.EqualTo(RenderPassEvent.BeforeRenderingPostProcessing));
        Assert.That(last.input, Is.EqualTo(ScriptableRenderPassInput.Color));
#endif
    }
}
