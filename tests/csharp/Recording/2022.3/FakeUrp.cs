using Unity.Collections;

namespace Penumbra.Tests;

internal sealed partial class FakeUrp
{
    internal static RenderingData Data(FakeScene scene, Camera camera)
    {
        RenderingData data = default;
        data.cullResults = scene.Cull();
        data.cameraData.camera = camera;
        data.cameraData.cameraType = scene.Camera;
        data.cameraData.renderType = scene.Overlay ? CameraRenderType.Overlay : CameraRenderType.Base;
        data.cameraData.targetTexture = scene.Texture();
        data.cameraData.cameraTargetDescriptor = scene.Target();
        data.cameraData.maxShadowDistance = scene.Distance;
        data.cameraData.Views = scene.ViewMatrices();
        data.cameraData.Projections = scene.Projections();
        data.cameraData.SetXr(new XRPass { Views = scene.Views });
        data.lightData.mainLightIndex = scene.MainLight ? 0 : -1;
        data.lightData.supportsMixedLighting = scene.MixedLighting;
        data.lightData.visibleLights = new NativeArray<VisibleLight> { Items = scene.Lights() };
        data.shadowData.supportsMainLightShadows = scene.Supported;
        data.shadowData.mainLightShadowmapWidth = 2048;
        data.shadowData.mainLightShadowmapHeight = 2048;
        data.shadowData.mainLightShadowCascadesCount = scene.Cascades;
        data.shadowData.supportsSoftShadows = scene.SoftShadows;
        data.shadowData.mainLightShadowCascadeBorder = scene.Border;
        return data;
    }

    private void RenderPasses(FakeScene scene, Camera camera, ScriptableRenderContext context,
                              PenumbraShadows feature, FrameKeywords keywords)
    {
        RenderingData data = Data(scene, camera);
        var renderer = new QueueOfPasses();
        feature?.AddRenderPasses(renderer, ref data);
        var queue = renderer.Queue.OrderBy(pass => (int)pass.renderPassEvent).ToList();
        foreach (ScriptableRenderPass pass in queue) pass.OnCameraSetup(new CommandBuffer(), ref data);
        foreach (ScriptableRenderPass pass in queue.Where(IsBeforeOpaques)) pass.Execute(context, ref data);
        DrawOpaques(keywords);
        Device.Target = "_CameraColorTexture";
        foreach (ScriptableRenderPass pass in queue.Where(pass => !IsBeforeOpaques(pass)))
            pass.Execute(context, ref data);
        keywords.AtTransparents = Now();
    }
}
