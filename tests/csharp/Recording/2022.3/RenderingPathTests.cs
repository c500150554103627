namespace Penumbra.Tests;

/// <summary>
/// URP 14 gives a camera depth before our pass by one of three ways: a forward prepass where depth is asked for no
/// later than BeforeRenderingGbuffer, the G-buffer's own depth after it, and of what is drawn forward in a deferred
/// renderer a prepass where normals are asked for too (UniversalRenderer.Setup, GetRenderPassInputs).
/// </summary>
public sealed class RenderingPathTests : FeatureTests
{
    private ScriptableRenderPass ShadowPass(bool deferredRenderer, bool overlay)
    {
        var renderer = new QueueOfPasses();
        renderer.supportedRenderingFeatures.msaa = !deferredRenderer;
        RenderingData data = FakeUrp.Data(new FakeScene { Overlay = overlay }, new Camera());
        feature.AddRenderPasses(renderer, ref data);
        return renderer.Queue.First();
    }

    [TestCase(false, false, false)]
    [TestCase(false, true, false)]
    [TestCase(true, false, false)]
    [TestCase(true, true, false)]
    [TestCase(true, false, true)]
    public void DepthIsThereBeforeThePass(bool deferredRenderer, bool overlay, bool wireframe)
    {
        GL.wireframe = wireframe;
        ScriptableRenderPass pass = ShadowPass(deferredRenderer, overlay);
        bool gbuffer = deferredRenderer && !overlay && !wireframe;
        bool normals = (pass.input & ScriptableRenderPassInput.Normal) != 0;
        Assert.That((pass.input & ScriptableRenderPassInput.Depth) != 0);
        Assert.That(normals, Is.EqualTo(gbuffer), "the prepass of what is drawn forward in deferred, and no other");
        Assert.That(pass.renderPassEvent, Is.EqualTo(gbuffer ? RenderPassEvent.AfterRenderingGbuffer
                                                             : RenderPassEvent.BeforeRenderingGbuffer));
    }
}
