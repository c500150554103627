using UnityEngine.Rendering.RenderGraphModule;

namespace Penumbra.Tests;

/// <summary>
/// A GPU with tiles keeps the picture on the chip from the camera's first draw to its last, if every pass in
/// between is a raster pass on the same colour that reads no attachment as a texture. In URP's Tile-Only Mode
/// anything else throws while the frame is recorded.
/// </summary>
public sealed class NativePassTests : FeatureTests
{
    [SetUp]
    public void SetUp() => feature.Settings.preset = QualityPreset.High;

    private RenderGraph.Pass[] Recorded(FakeScene scene)
    {
        Render(scene);
        return urp.Graph.Passes.ToArray();
    }

    private static bool Draws(RenderGraph.Pass pass) =>
        pass.IsRaster && pass.Attachment.IsValid() && pass.Attachment.Handle.What == "_CameraColorTexture";

    [Test]
    public void NothingStandsBetweenTheCamerasDraws()
    {
        foreach (DebugView view in System.Enum.GetValues(typeof(DebugView)))
        {
            feature.Settings.debugView = view;
            foreach (FakeScene scene in FakeScene.Every())
            {
                RenderGraph.Pass[] passes = Recorded(scene);
                RenderGraph.Pass[] between = passes.SkipWhile(pass => !Draws(pass)).ToArray();
                Assert.That(between.First().Name, Is.EqualTo("occlusion mesh"), scene.ToString());
                Assert.That(between.Where(pass => !Draws(pass)).Select(pass => pass.Name), Is.Empty, scene.ToString());
                Assert.That(between.SelectMany(pass => pass.Textures).Select(use => use.texture.Handle.What),
                            Has.None.EqualTo("_CameraColorTexture"), scene.ToString());
            }
        }
    }

    [Test]
    public void TheChainIsDrawnBeforeThem()
    {
        RenderGraph.Pass[] passes = Recorded(new FakeScene());
        Assert.That(passes.First(pass => pass.Data != null).Name, Is.EqualTo("Penumbra Shadows"));
        Assert.That(passes.TakeWhile(pass => !Draws(pass)).Count(), Is.EqualTo(1));
    }

    /// <summary>
    /// Otherwise the graph would give the textures' memory to others, and shaders of the opaque pass would read that.
    /// </summary>
    [Test]
    public void WhatShadersFindByNameOutlivesThePass()
    {
        AddedTechniques.AddMeans();
        feature.Settings.preset = QualityPreset.Custom;
        feature.Settings.custom = AddedTechniques.Options();
        feature.Create();
        RenderGraph.Pass pass = Recorded(new FakeScene()).Single(any => any.Name == "Penumbra Shadows");
        AddedTechniques.Remove();
        Assert.That(pass.Globals.Select(global => Shader.PropertyName(global.property)),
                    Is.EquivalentTo(new[] { "_ScreenSpaceShadowmapTexture", "_PenumbraBlurredTexture" }));
    }

    [Test]
    public void NothingIsRestoredWhereNothingWasSwitched() =>
        Assert.That(Recorded(new FakeScene { Projection = Matrix4x4.zero }).Select(pass => pass.Name),
                    Is.EqualTo(new[] { "occlusion mesh", "opaques", "transparents" }));
}
