namespace Penumbra.Tests;

/// <summary>
/// URP's keywords are where URP has put them whenever anybody else looks, whatever happens in between.
/// </summary>
public sealed class KeywordTests : FeatureTests
{
    [SetUp]
    public void SetUp() => PresetFallback.Choose(feature.Settings, QualityPreset.High);  // with a mask there are four draws

    [Test]
    public void EveryCameraLeavesThemAsUrpDoes()
    {
        int ours = 0;
        foreach (FakeScene scene in FakeScene.Every())
        {
            FrameKeywords without = new FakeUrp().Render(scene);
            var urp = new FakeUrp();
            FrameKeywords with = urp.Render(scene, feature);
            Assert.That(with.AtTransparents, Is.EqualTo(without.AtTransparents), scene.ToString());
            Assert.That(with.AtEnd, Is.EqualTo(without.AtEnd), scene.ToString());
            bool switched = with.AtOpaques == ShadowKeywords.ScreenName;
            if (!switched) Assert.That(with.AtOpaques, Is.EqualTo(without.AtOpaques), scene.ToString());
            Assert.That(switched, Is.EqualTo(urp.Device.Draws.Count > 0), scene.ToString());
            if (switched) Assert.That(scene.UrpDraws, scene.ToString());
            ours += switched ? 1 : 0;
        }
        Assert.That(ours, Is.GreaterThan(20));
    }

    // These scenes belong to another renderer, which does not have the feature.
    private static readonly FakeScene[] Others =
        { new FakeScene { Cascades = 1 }, new FakeScene { Casters = false }, new FakeScene() };

    private static string[] Frames(FakeUrp urp) => Others.Select(other => urp.Render(other).ToString()).ToArray();

    [Test]
    public void ACameraThatThrowsAnywhereDoesNotReachTheNext()
    {
        feature.Settings.reflectionProbes = true;
        var drawn = new HashSet<CameraType>();
        foreach (FakeScene scene in FakeScene.Every())
        {
            var urp = new FakeUrp();
            urp.Render(scene, feature);
            if (urp.Device.Draws.Count == 0) continue;
            drawn.Add(scene.Camera);
            Assert.That(FailEverywhere(scene), Is.GreaterThan(30), "commands of a frame, each of which failed once");
        }
        Assert.That(drawn, Is.EquivalentTo(new[]
        {
            CameraType.Game, CameraType.SceneView, CameraType.VR, CameraType.Reflection,
        }));
    }

    [Test]
    public void ADebugViewThatThrowsDoesNotReachTheNext()
    {
        int without = FailEverywhere(new FakeScene());
        feature.Settings.debugView = DebugView.Visibility;
        Assert.That(FailEverywhere(new FakeScene()), Is.GreaterThan(without), "commands of the view");
    }

    // Draws a camera of the scene for each command that it records, which fails there, and returns their number.
    private int FailEverywhere(FakeScene scene)
    {
        string[] expected = Frames(new FakeUrp());
        FrameKeywords sound = new FakeUrp().Render(scene, feature);
        int points = 0;
        for (bool failed = true; failed; ++points)
        {
            var urp = new FakeUrp();
            CommandBuffer.FailAt = points;
            urp.Render(scene, feature);
            failed = CommandBuffer.FailAt < 0;
            CommandBuffer.FailAt = -1;
            string place = $"{scene}, after command {points}";
            Assert.That(Frames(urp), Is.EqualTo(expected), place);
            Assert.That(urp.Render(scene, feature).ToString(), Is.EqualTo(sound.ToString()), place);
        }
        return points;
    }

    [Test]
    public void AStackOfCamerasSwitchesForEach()
    {
        var urp = new FakeUrp();
        foreach (int cascades in new[] { 4, 1, 2 })
        {
            FrameKeywords keywords = urp.Render(new FakeScene { Cascades = cascades }, feature);
            Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.ScreenName));
            Assert.That(keywords.AtEnd,
                        Is.EqualTo(cascades == 1 ? ShadowKeywords.MapName : ShadowKeywords.CascadesName));
        }
    }

    [Test]
    public void ADisposedFeatureWatchesNoCameras()
    {
        var context = new ScriptableRenderContext { Device = new FakeDevice() };
        ShadowKeywords.Global.Open(new CommandBuffer());
        feature.Dispose();
        RenderPipelineManager.BeginCamera(context, new Camera());
        Assert.That(ShadowKeywords.Global.IsOpen);
        feature.Create();
        RenderPipelineManager.BeginCamera(context, new Camera());
        Assert.That(ShadowKeywords.Global.IsOpen, Is.False);
    }
}
