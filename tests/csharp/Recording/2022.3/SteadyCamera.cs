namespace Penumbra.Tests;

/// <summary>A camera whose frames allocate what the feature does, nothing of the fake URP's own.</summary>
internal sealed class SteadyCamera
{
    private readonly QueueOfPasses renderer = new QueueOfPasses();
    private readonly CommandBuffer commands = new CommandBuffer();
    private readonly ScriptableRenderContext context = new ScriptableRenderContext { Device = new FakeDevice() };
    private RenderingData data;

    internal SteadyCamera(FakeScene scene) { data = FakeUrp.Data(scene, scene.MakeCamera()); }

    internal void Render(PenumbraShadows feature)
    {
        List<ScriptableRenderPass> queue = renderer.Queue;
        queue.Clear();
        feature.AddRenderPasses(renderer, ref data);
        for (int i = 0; i < queue.Count; ++i) queue[i].OnCameraSetup(commands, ref data);
        for (int i = 0; i < queue.Count; ++i) queue[i].Execute(context, ref data);
    }
}
