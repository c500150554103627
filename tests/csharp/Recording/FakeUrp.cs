namespace Penumbra.Tests;

/// <summary>
/// The order of a camera's frame in URP, as far as the shadow keywords go; what differs between the versions is in
/// the other half of this class.
/// </summary>
internal sealed partial class FakeUrp
{
    internal FakeDevice Device { get; } = new FakeDevice();

    /// <summary>
    /// Renders a frame; without a feature, URP alone. A throwing camera ends there, as it does in Unity.
    /// </summary>
    internal FrameKeywords Render(FakeScene scene, PenumbraShadows feature = null)
    {
        var keywords = new FrameKeywords();
        Camera camera = scene.MakeCamera();
        var context = new ScriptableRenderContext { Device = Device };
        RenderPipelineManager.BeginCamera(context, camera);
        Device.SetKeyword(ShadowKeywords.MapName, false);  // this is ScriptableRenderer.ClearRenderingState
        Device.SetKeyword(ShadowKeywords.CascadesName, false);
        Device.SetKeyword(ReceiverFade.MixingName, false);
        if (scene.UrpHasNothingToDraw && scene.Camera != CameraType.Preview)
            Device.SetKeyword(ShadowKeywords.MapName, true);
        if (scene.UrpDraws && scene.Camera != CameraType.Preview)  // this is MainLightShadowCasterPass
        {
            Device.SetKeyword(ShadowKeywords.MapName, scene.Cascades == 1);
            Device.SetKeyword(ShadowKeywords.CascadesName, scene.Cascades > 1);
        }
        try
        {
            RenderPasses(scene, camera, context, feature, keywords);
        }
        catch (InvalidOperationException) { }
        RenderPipelineManager.EndCamera(context, camera);
        keywords.AtEnd = Now();
        return keywords;
    }

    private string Now() => string.Join(" ", Device.Keywords);

    private void DrawOpaques(FrameKeywords keywords)
    {
        keywords.AtOpaques = Now();
        keywords.ReceiversAtOpaques = Device.Uniforms.TryGetValue("_MainLightShadowParams", out object receivers)
                                          ? (Vector4?)receivers : null;
        keywords.AtTransparents = keywords.AtOpaques;
    }

    private static bool IsBeforeOpaques(ScriptableRenderPass pass) => (int)pass.renderPassEvent < 250;
}

/// <summary>A renderer that keeps the passes that a feature enqueues.</summary>
internal sealed class QueueOfPasses : ScriptableRenderer { }
