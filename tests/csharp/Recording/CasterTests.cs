#if UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace Penumbra.Tests;

/// <summary>
/// Passes that draw the objects of the scene: the tests say which of them, by which program, into what.
/// </summary>
public sealed class CasterTests : FeatureTests
{
    [SetUp]
    public void SetUp()
    {
        Use(AddedTechniques.Options());
        AddedTechniques.AddMeans();
        CullingResults.Next = new CullingResults { HasCasters = true };
    }

    private static GraphPass Casters(PassFrequency runs, int target, int depth = -1, bool testsShadowMap = false) =>
        new GraphPass
        {
            kind = PassKind.Casters, asset = "Means.shader", program = "Depths", runs = runs, depth = depth,
            testsShadowMap = testsShadowMap,
            writes = target < 0 ? new GraphBinding[0] : new[] { GraphBinding.Texture(target) },
        };

    internal static TechniqueGraph Graph(GraphExtent extent, GraphPass casters) => new TechniqueGraph
    {
        name = "casters",
        textures = new[]
        {
            new GraphTexture("layer", extent, GraphicsFormat.R32_SFloat),
            new GraphTexture("depth", extent, GraphicsFormat.D32_SFloat),
            new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
        },
        passes = new[]
        {
            casters,
            new GraphPass
            {
                asset = PenumbraShadows.ShaderFile, program = "Resolve",
                reads = new[] { GraphBinding.Texture("_Layer", 0) },
                writes = new[] { GraphBinding.Texture(2) },
            },
        },
        visibility = 2,
    };

    internal static TechniqueGraph OfMap => Graph(GraphExtent.Map, Casters(PassFrequency.Cascade, 0, depth: 1));

    private List<FakeDevice.DrawCall> Draws(TechniqueGraph graph)
    {
        AddedTechniques.Use(graph);
        feature.Create();
        Render();
        return urp.Device.Draws;
    }

    private static string Projection(FakeDevice.DrawCall draw) =>
        (1.0f / (((Matrix4x4, Matrix4x4))draw.Uniforms["view"]).Item2.m00).ToString();

    /// <summary>Each cascade is culled for itself, because the camera's casters are not all of the light's.</summary>
    [Test]
    public void ACascadeHasTheCastersThatTheLightSees()
    {
        FakeDevice.DrawCall[] draws = Draws(OfMap).Where(draw => draw.Pass != "Resolve").ToArray();
        Assert.That(draws.Select(draw => draw.Pass),
                    Is.EqualTo(new[] { 1, 2, 3, 4 }.Select(radius => "ShadowCaster by Depths of " + radius)));
        Assert.That(draws.Select(Projection), Is.EqualTo(new[] { "1", "2", "3", "4" }));
        Assert.That(draws.Select(draw => draw.Uniforms["_ShadowBias"]),
                    Is.EqualTo(new[] { 1, 2, 3, 4 }.Select(radius => new Vector4(radius, 1024.0f, 0.0f, 0.0f))));
        Assert.That(draws.Select(draw => (draw.Viewport.Value.x, draw.Viewport.Value.y)).Distinct().Count(), Is.EqualTo(4), "tiles");
        Assert.That(draws.Select(draw => draw.Target).Distinct().Single(), Does.Match("^_Penumbra.* over _Penumbra"));
        Assert.That(draws.Select(draw => draw.Uniforms["cleared"]), Is.All.EqualTo("depthcolour"));
    }

    /// <summary>
    /// The files are those that the C++ tools validate and measure; the technique has no C# of its own.
    /// </summary>
    [Test]
    public void AnAddedTechniqueDrawsThemAndItsFilterFindsTheTextures()
    {
        AddedTechniques.AddLayers();
        List<FakeDevice.DrawCall> draws = Draws(AddedTechniques.Layers);
        Assert.That(draws.Select(draw => draw.Pass),
                    Is.EqualTo(new[] { "Layers", "Nearest" }
                                   .SelectMany(pass => new[] { 1, 2, 3, 4 }.Select(
                                       radius => "ShadowCaster by " + pass + " of " + radius))
                                   .Append("Resolve")));
        FakeDevice.DrawCall layers = draws[0], nearest = draws[4], resolve = draws.Last();
        Assert.That((layers.Uniforms["cleared"], nearest.Uniforms["cleared"]), Is.EqualTo(("colour", "depth")));
        Assert.That(draws.Take(4).Select(draw => draw.Viewport.Value), Is.Unique);
        Assert.That(resolve.Textures["_PenumbraLayersTexture"], Is.EqualTo(layers.Target));
        Assert.That(resolve.Textures["_PenumbraNearestTexture"], Is.EqualTo(nearest.Target));
        Assert.That(layers.Target, Is.Not.EqualTo(nearest.Target));
    }

    /// <summary>Transparent materials have no ShadowCaster pass.</summary>
    [Test]
    public void BlendedCastersAreDrawnByThePassesThatTheyHave()
    {
        TechniqueGraph map = OfMap;
        map.passes[0].blended = true;
        Assert.That(Draws(map).Where(draw => draw.Pass != "Resolve").Select(draw => draw.Pass),
                    Is.EqualTo(new[] { 1, 2, 3, 4 }.Select(
                        radius => "UniversalForward, UniversalForwardOnly, SRPDefaultUnlit by Depths of " + radius)));
        TechniqueGraph seen = Graph(GraphExtent.Screen, Casters(PassFrequency.Frame, 0, depth: 1));
        seen.passes[0].blended = true;
        Assert.That(Draws(seen)[0].Pass,
                    Is.EqualTo("UniversalForward, UniversalForwardOnly, SRPDefaultUnlit by Depths"));
    }

    [Test]
    public void TheCamerasMatricesAreThereAgain()
    {
        FakeDevice.DrawCall resolve = Draws(OfMap).Last();
        Assert.That(resolve.Pass, Is.EqualTo("Resolve"));
        Assert.That(resolve.Uniforms["view"], Is.EqualTo((scene.ViewMatrices()[0], scene.Projections()[0])));
    }

    [Test]
    public void ALayerIsACascadesOwn()
    {
        TechniqueGraph graph = Graph(GraphExtent.Tile, Casters(PassFrequency.Cascade, -1, depth: 0));
        graph.textures[0] = new GraphTexture("depth", GraphExtent.Tile, GraphicsFormat.D32_SFloat);
        LeaveOutDepth(graph);
        FakeDevice.DrawCall[] draws = Draws(graph).Where(draw => draw.Pass != "Resolve").ToArray();
        Assert.That(draws.Select(draw => draw.Target.Substring(draw.Target.IndexOf(' '))),
                    Is.EqualTo(new[] { " slice 0", " slice 1", " slice 2", " slice 3" }));
        Assert.That(draws.Select(draw => draw.Uniforms["cleared"]), Is.All.EqualTo("depth"));
        Assert.That(draws.Select(draw => draw.Viewport), Is.All.Null);
    }

    [Test]
    public void WhatTheCameraSeesIsDrawnOnce()
    {
        FakeDevice.DrawCall draw = Draws(Graph(GraphExtent.Screen, Casters(PassFrequency.Frame, 0, depth: 1)))[0];
        Assert.That(draw.Pass, Is.EqualTo("DepthOnly by Depths"));
        Assert.That(draw.Viewport, Is.Null);
    }

    private TechniqueGraph AgainstTheMap()
    {
        TechniqueGraph graph = Graph(GraphExtent.Map, Casters(PassFrequency.Cascade, 0, testsShadowMap: true));
        LeaveOutDepth(graph);
        return graph;
    }

    private static void LeaveOutDepth(TechniqueGraph graph)
    {
        graph.textures = new[] { graph.textures[0], graph.textures[2] };
        graph.passes[1].reads = new[] { GraphBinding.Texture("_Layer", 0) };
        graph.passes[1].writes = new[] { GraphBinding.Texture(1) };
        graph.visibility = 1;
    }

#if UNITY_6000_0_OR_NEWER
    [Test]
    public void TheShadowMapTestsAndStays()
    {
        FakeDevice.DrawCall draw = Draws(AgainstTheMap())[0];
        Assert.That(draw.Target, Does.EndWith(" over _MainLightShadowmapTexture"));
        Assert.That(draw.Uniforms["cleared"], Is.EqualTo("colour"));
    }

    /// <summary>
    /// A context from an earlier frame does not count: the engine would be asked through what is no longer there.
    /// </summary>
    [Test]
    public void WithoutTheCamerasBeginNothingIsCulled()
    {
        Draws(OfMap);
        RenderingData data = FakeUrp.Data(scene, scene.MakeCamera());
        var renderer = new QueueOfPasses();
        feature.AddRenderPasses(renderer, ref data);
        var graph = new RenderGraph();
        foreach (ScriptableRenderPass pass in renderer.Queue) pass.RecordRenderGraph(graph, data.Frame);
        Assert.That(graph.Passes.Single(pass => pass.Name == "Penumbra Shadows").Lists, Is.Empty);
    }

    [Test]
    public void TheGraphKnowsTheLists()
    {
        Draws(OfMap);
        Assert.That(urp.Graph.Passes.Single(pass => pass.Name == "Penumbra Shadows").Lists.Count, Is.EqualTo(4));
    }
#else
    [Test]
    public void TheShadowMapIsUrps()
    {
        Assert.That(Draws(AgainstTheMap()), Is.Empty);
        Assert.That(feature.MissingPass, Does.Contain("tests casters against the shadow map"));
    }
#endif

    [Test]
    public void AKeywordThatObjectsHaveNotIsNamed()
    {
        TechniqueGraph graph = OfMap;
        graph.passes[0].asset = PenumbraShadows.ShaderFile;
        graph.passes[0].program = "Resolve";
        Assert.That(Draws(graph), Is.Empty);
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.MissingPass));
        Assert.That(feature.MissingPass, Does.EndWith("which do not enable its keyword _PENUMBRA_TENT_3X3"));
    }

    [Test]
    public void ACascadeThatWasNotDrawnAnewIsNotCulled()
    {
        var casters = new CasterFrame { camera = scene.MakeCamera(), light = scene.Lights()[0], seen = scene.Cull() };
        ShadowFrame frame = default;
        frame.layout = new AtlasLayout(2048, 4);
        frame.updatedCascades = 0b0100;
#if UNITY_6000_0_OR_NEWER
        CasterCulling.Cull(default, casters, 0, new UniversalShadowData(), frame);
#else
        CasterCulling.Cull(default, casters, 0, default, frame);
#endif
        Assert.That(casters.cascades.Select(cascade => cascade.isCulled),
                    Is.EqualTo(new[] { false, false, true, false }));
    }

    /// <summary>The inspector says which objects Unity's lists leave out or draw too much.</summary>
    [Test]
    public void TheInspectorSaysWhichObjectsTheyAre()
    {
        Draws(OfMap);
        Assert.That(FeatureAdvice.For(FeatureSurroundings.Of(feature)).Select(advice => advice.text),
                    Has.Some.Contains("Shadows Only"));
        AddedTechniques.Remove();
        Assert.That(FeatureAdvice.For(FeatureSurroundings.Of(feature)).Select(advice => advice.text),
                    Has.None.Contains("Shadows Only"));
    }
}
