using Unity.Collections;
using UnityEngine.Rendering.RenderGraphModule;

namespace Penumbra.Tests;

internal sealed partial class FakeUrp
{
    /// <summary>The graph of the last camera.</summary>
    internal RenderGraph Graph { get; private set; }

    internal static RenderingData Data(FakeScene scene, Camera camera)
    {
        var frame = new ContextContainer();
        frame.Items[typeof(UniversalRenderingData)] = new UniversalRenderingData { cullResults = scene.Cull() };
        frame.Items[typeof(UniversalLightData)] = new UniversalLightData
        {
            mainLightIndex = scene.MainLight ? 0 : -1, supportsMixedLighting = scene.MixedLighting,
            visibleLights = new NativeArray<VisibleLight> { Items = scene.Lights() },
        };
        frame.Items[typeof(UniversalShadowData)] = new UniversalShadowData
        {
            supportsMainLightShadows = scene.Supported, mainLightShadowCascadesCount = scene.Cascades,
            mainLightShadowmapWidth = 2048, mainLightShadowmapHeight = 2048,
            supportsSoftShadows = scene.SoftShadows, mainLightShadowCascadeBorder = scene.Border,
        };
        var cameraData = new UniversalCameraData
        {
            renderType = scene.Overlay ? CameraRenderType.Overlay : CameraRenderType.Base,
            camera = camera, cameraType = scene.Camera, targetTexture = scene.Texture(),
            cameraTargetDescriptor = scene.Target(), maxShadowDistance = scene.Distance,
            Views = scene.ViewMatrices(), Projections = scene.Projections(),
        };
        cameraData.SetXr(new XRPass { Views = scene.Views });
        frame.Items[typeof(UniversalCameraData)] = cameraData;
        frame.Items[typeof(UniversalResourceData)] = new UniversalResourceData
        {
            cameraDepthTexture = Texture("_CameraDepthTexture"),
            Colour = Texture(scene.ToBackBuffer ? "back buffer" : "_CameraColorTexture"),
            mainShadowsTexture = Texture("_MainLightShadowmapTexture"),
        };
        return new RenderingData(frame);
    }

    private static TextureHandle Texture(string name) => new TextureHandle { Handle = new RTHandle { What = name } };

    private void RenderPasses(FakeScene scene, Camera camera, ScriptableRenderContext context,
                              PenumbraShadows feature, FrameKeywords keywords)
    {
        RenderingData data = Data(scene, camera);
        var renderer = new QueueOfPasses();
        feature?.AddRenderPasses(renderer, ref data);
        Graph = new RenderGraph();
        TextureHandle colour = data.Frame.Get<UniversalResourceData>().activeColorTexture;
        var own = new Queue<(string name, int before)>(OwnDraws);
        // The whole graph is recorded before any of it runs.
        foreach (ScriptableRenderPass pass in renderer.Queue.OrderBy(pass => (int)pass.renderPassEvent))
        {
            AddOwn(own, (int)pass.renderPassEvent, colour);
            pass.RecordRenderGraph(Graph, data.Frame);
        }
        AddOwn(own, int.MaxValue, colour);
        foreach (RenderGraph.Pass pass in Graph.Passes.ToList())
        {
            if (pass.Name == "opaques") DrawOpaques(keywords);
            else if (pass.Name == "transparents") keywords.AtTransparents = Now();
            else if (pass.Data != null) Run(pass, context);
        }
    }

    // These are what URP itself draws into the camera's colour, and the event whose passes come behind it.
    private static readonly (string name, int before)[] OwnDraws =
    {
        ("occlusion mesh", (int)RenderPassEvent.BeforeRenderingGbuffer), ("opaques", 250),
        ("transparents", (int)RenderPassEvent.AfterRenderingTransparents),
    };

    private void AddOwn(Queue<(string name, int before)> own, int next, in TextureHandle colour)
    {
        while (own.Count > 0 && own.Peek().before <= next)
            Graph.Passes.Add(new RenderGraph.Pass { Name = own.Dequeue().name, IsRaster = true, Attachment = colour });
    }

    private static void Run(RenderGraph.Pass pass, ScriptableRenderContext context)
    {
        var commands = new CommandBuffer();
        try
        {
            Record(pass, commands);
            foreach ((TextureHandle texture, int property) in pass.Globals)
                commands.SetGlobalTexture(property, texture.Handle);
        }
        finally
        {
            context.ExecuteCommandBuffer(commands);  // what was recorded may still run
        }
    }

    private static void Record(RenderGraph.Pass pass, CommandBuffer commands)
    {
        if (!pass.IsRaster)
        {
            pass.Run(new UnsafeGraphContext { cmd = new UnsafeCommandBuffer { Wrapped = commands } });
            return;
        }
        commands.Target(pass.Attachment.Handle.What);
        pass.Run(new RasterGraphContext { cmd = new RasterCommandBuffer { Wrapped = commands } });
    }
}
