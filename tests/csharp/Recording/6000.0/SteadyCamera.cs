using UnityEngine.Rendering.RenderGraphModule;

namespace Penumbra.Tests;

/// <summary>A camera whose frames allocate what the feature does, nothing of the fake URP's own.</summary>
internal sealed class SteadyCamera
{
    private readonly QueueOfPasses renderer = new QueueOfPasses();
    private readonly RenderGraph graph = new RenderGraph();
    private readonly UnsafeGraphContext context;
    private readonly RasterGraphContext rasterContext;
    private readonly Camera camera;
    private RenderingData data;

    internal SteadyCamera(FakeScene scene)
    {
        camera = scene.MakeCamera();
        data = FakeUrp.Data(scene, camera);
        var commands = new CommandBuffer();
        context = new UnsafeGraphContext { cmd = new UnsafeCommandBuffer { Wrapped = commands } };
        rasterContext = new RasterGraphContext { cmd = new RasterCommandBuffer { Wrapped = commands } };
    }

    internal void Render(PenumbraShadows feature)
    {
        List<ScriptableRenderPass> queue = renderer.Queue;
        queue.Clear();
        RenderPipelineManager.BeginCamera(default, camera);
        feature.AddRenderPasses(renderer, ref data);
        for (int i = 0; i < queue.Count; ++i) queue[i].RecordRenderGraph(graph, data.Frame);
        for (int i = 0; i < graph.Passes.Count; ++i)
            if (graph.Passes[i].IsRaster) graph.Passes[i].Run(rasterContext);
            else graph.Passes[i].Run(context);
        graph.GiveBack();
        RenderPipelineManager.EndCamera(default, camera);
    }
}
