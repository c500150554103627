namespace Penumbra.Tests;

/// <summary>Tests that set what the stand-ins of the engine answer, which is as before after each of them.</summary>
public abstract class EngineTests
{
    private static readonly (PropertyInfo property, object value)[] Answers =
        new[]
        {
            typeof(CommandBuffer), typeof(Debug), typeof(GL), typeof(GraphicsSettings), typeof(QualitySettings),
            typeof(ScalableBufferManager), typeof(SystemInfo), typeof(TerrainData), typeof(Time),
        }.SelectMany(type => type.GetProperties(BindingFlags.Static | BindingFlags.Public))
            .Where(property => property.CanWrite).Select(property => (property, property.GetValue(null))).ToArray();

    // They are asked for before the first test changes one of them.
    static EngineTests() { }

    [TearDown]
    public void RestoreTheEngine()
    {
        foreach ((PropertyInfo property, object value) in Answers) property.SetValue(null, value);
        SystemInfo.Unfiltered.Clear();
        CullingResults.Next = default;
        VolumeManager.instance.stack.Components.Clear();
        AddedTechniques.Remove();
    }
}

/// <summary>Tests of the frames that a pipeline renders of a scene with a feature.</summary>
public abstract class FeatureTests : EngineTests
{
    private protected PenumbraShadows feature;
    private protected FakeUrp urp;
    private protected FakeScene scene;
    private protected FrameKeywords keywords;

    [SetUp]
    public void MakeTheFeature()
    {
        FakeShader.Install();
        feature = new PenumbraShadows();
        feature.Create();
        urp = new FakeUrp();
        scene = new FakeScene();
    }

    [TearDown]
    public void DisposeOfTheFeature() => feature.Dispose();

    /// <summary>Renders a frame, whose passes are the result.</summary>
    private protected string[] Render()
    {
        urp.Device.Draws.Clear();
        urp.Device.Copies.Clear();
        keywords = urp.Render(scene, feature);
        return Passes();
    }

    private protected string[] Render(FakeScene of)
    {
        scene = of;
        return Render();
    }

    private protected string[] Passes() => urp.Device.Draws.Select(draw => draw.Pass).ToArray();

    private protected FakeDevice.DrawCall Draw(string pass) => urp.Device.Draws.Single(draw => draw.Pass == pass);

    private protected FakeDevice.DrawCall[] Draws(string pass) =>
        urp.Device.Draws.Where(draw => draw.Pass == pass).ToArray();

    private protected static Vector4 Vector(FakeDevice.DrawCall draw, string name) => (Vector4)draw.Uniforms[name];

    private protected void Use(ShadowOptions options)
    {
        feature.Settings.preset = QualityPreset.Custom;
        feature.Settings.custom = options;
    }

    /// <summary>A Volume in which the camera stands, with a preset of its own.</summary>
    private protected static PenumbraShadowsVolume Volume(QualityPreset preset)
    {
        var volume = ScriptableObject.CreateInstance<PenumbraShadowsVolume>();
        volume.preset.Set(preset);
        VolumeManager.instance.stack.Components[typeof(PenumbraShadowsVolume)] = volume;
        return volume;
    }
}
