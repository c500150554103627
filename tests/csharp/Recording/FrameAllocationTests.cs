namespace Penumbra.Tests;

/// <summary>
/// Runs whole frames, from AddRenderPasses to the last pass that is enqueued: once the chains and textures are
/// there, none leaves the collector anything, nor makes a texture.
/// </summary>
public sealed class FrameAllocationTests : FeatureTests
{
    [SetUp]
    public void SetUp() => feature.Settings.preset = QualityPreset.Custom;

    private static ShadowOptions Screen(QualityPreset preset) => PresetFallback.Options(preset);

    private static object[] Case(Action technique, params ShadowOptions[] turns) => new object[] { technique, turns };

    private static object[] Added(Action technique) =>
        Case(technique, AddedTechniques.Options(), Screen(QualityPreset.High));

    private static object[] Added(TechniqueGraph graph) => Added(() =>
    {
        AddedTechniques.AddMeans();
        AddedTechniques.Use(graph);
    });

    // Each camera has its options, as Volumes give them. The chains have other lengths, and textures that are owned
    // or lent, baked or of the frame before.
    private static readonly object[] Turns =
    {
        Case(() => { }, Screen(QualityPreset.Low)),
        Case(() => { }, Screen(QualityPreset.Low), Screen(QualityPreset.Ultra)),
        Case(() => { }, ShadowPresets.Options(QualityPreset.Low), ShadowPresets.Options(QualityPreset.Ultra)),
        Added(() => AddedTechniques.AddMeans()), Added(() => AddedTechniques.AddBlocks()), Added(CasterTests.OfMap),
        Added(CameraStoreTests.Baked(GraphExtent.Tile)), Added(CameraStoreTests.Mean()),
    };

    [Test]
    public void AnAllocationIsSeen()
    {
        byte[] kept = null;
        Assert.That(Allocations.Of(() => kept = new byte[1]), Is.Positive);
        Assert.That(kept, Has.Length.EqualTo(1));
    }

    [TestCaseSource(nameof(Turns))]
    public void FramesAllocateNothing(Action technique, object options)
    {
        technique();
        feature.Create();
        feature.Settings.noise = NoiseMode.Accumulated;
        var turns = (ShadowOptions[])options;
        var cameras = new SteadyCamera[turns.Length];
        for (int i = 0; i < cameras.Length; ++i) cameras[i] = new SteadyCamera(new FakeScene());
        CommandBuffer.Silent = true;
        void Frames(int count)
        {
            for (int frame = 0; frame < count; ++frame, ++Time.frameCount)
                for (int i = 0; i < cameras.Length; ++i)
                {
                    turns[i].angularDiameterDegrees += 1e-5f;
                    feature.Settings.custom = turns[i];
                    cameras[i].Render(feature);
                }
        }

        Frames(3);
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.None));
        Assert.That(Allocations.Of(() => Frames(1000)), Is.Zero);
    }
}
