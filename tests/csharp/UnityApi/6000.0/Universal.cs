using Unity.Collections;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

[AttributeUsage(AttributeTargets.Class)]
public class SupportedOnRendererAttribute : Attribute
{
    public Type[] rendererTypes { get; }

    public SupportedOnRendererAttribute(Type renderer) { rendererTypes = new[] { renderer }; }
}

#if !UNITY_6000_5_OR_NEWER
public class RenderGraphSettings : IRenderPipelineGraphicsSettings
{
    public bool enableRenderCompatibilityMode { get; set; }
}
#endif

public struct RenderingData
{
    [OwnBehaviour] public ContextContainer Frame;

    public CameraData cameraData;
    public LightData lightData;
    public ShadowData shadowData;

    public ref CullingResults cullResults => ref Frame.Get<UniversalRenderingData>().cullResults;

    [OwnBehaviour]
    public RenderingData(ContextContainer frame)
    {
        Frame = frame;
        cameraData = new CameraData { Frame = frame };
        lightData = new LightData { Frame = frame };
        shadowData = new ShadowData { Frame = frame };
    }
}

public struct LightData
{
    [OwnBehaviour] public ContextContainer Frame;

    public ref int mainLightIndex => ref Frame.Get<UniversalLightData>().mainLightIndex;
    public ref bool supportsMixedLighting => ref Frame.Get<UniversalLightData>().supportsMixedLighting;
    public ref NativeArray<VisibleLight> visibleLights => ref Frame.Get<UniversalLightData>().visibleLights;
}

public struct ShadowData
{
    [OwnBehaviour] public ContextContainer Frame;

    private UniversalShadowData Data => Frame.Get<UniversalShadowData>();

    public ref bool supportsMainLightShadows => ref Data.supportsMainLightShadows;
    public ref int mainLightShadowmapWidth => ref Data.mainLightShadowmapWidth;
    public ref int mainLightShadowmapHeight => ref Data.mainLightShadowmapHeight;
    public ref int mainLightShadowCascadesCount => ref Data.mainLightShadowCascadesCount;
    public ref Vector3 mainLightShadowCascadesSplit => ref Data.mainLightShadowCascadesSplit;
    public ref float mainLightShadowCascadeBorder => ref Data.mainLightShadowCascadeBorder;
    public ref bool supportsSoftShadows => ref Data.supportsSoftShadows;
}

public struct CameraData
{
    [OwnBehaviour] public ContextContainer Frame;

    private UniversalCameraData Data => Frame.Get<UniversalCameraData>();

    public ref Camera camera => ref Data.camera;
    public ref RenderTexture targetTexture => ref Data.targetTexture;
    public ref CameraType cameraType => ref Data.cameraType;
    public ref float maxShadowDistance => ref Data.maxShadowDistance;

    public XRPass xr { get => Data.xr; internal set => Data.SetXr(value); }
}

public class UniversalRenderingData : ContextItem
{
    public CullingResults cullResults;

    public override void Reset() { }
}

public class UniversalLightData : ContextItem
{
    public int mainLightIndex;
    public bool supportsMixedLighting;
    public NativeArray<VisibleLight> visibleLights;

    public override void Reset() { }
}

public class UniversalShadowData : ContextItem
{
    public bool supportsMainLightShadows;
    public int mainLightShadowmapWidth, mainLightShadowmapHeight, mainLightShadowCascadesCount;
    public Vector3 mainLightShadowCascadesSplit;
    public float mainLightShadowCascadeBorder;
    public bool supportsSoftShadows;

    public override void Reset() { }
}

public class UniversalCameraData : ContextItem
{
    [OwnBehaviour] public Matrix4x4[] Views, Projections;

    public Camera camera;
    public CameraRenderType renderType;
    public RenderTexture targetTexture;
    public RenderTextureDescriptor cameraTargetDescriptor;
    public CameraType cameraType;
    public float maxShadowDistance;

    public XRPass xr { get; internal set; }

    public Matrix4x4 GetViewMatrix(int viewIndex = 0) => Views[viewIndex];
    public Matrix4x4 GetProjectionMatrix(int viewIndex = 0) => Projections[viewIndex];

    public override void Reset() { }

    [OwnBehaviour] public void SetXr(XRPass pass) => xr = pass;
}

public class UniversalResourceData : ContextItem
{
    [OwnBehaviour] public TextureHandle Colour;

    public TextureHandle activeColorTexture => Colour;
    public TextureHandle mainShadowsTexture { get; [OwnBehaviour] set; }
    public TextureHandle cameraDepthTexture { get; [OwnBehaviour] set; }

    public override void Reset() { }
}

public abstract partial class ScriptableRenderPass
{
    public RenderPassEvent renderPassEvent { get; set; }
    public ScriptableRenderPassInput input { get; private set; }
    public bool requiresIntermediateTexture { get; set; }
    protected internal ProfilingSampler profilingSampler { get; set; }

    public void ConfigureInput(ScriptableRenderPassInput passInput) => input = passInput;

    public virtual void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData) { }
}

public static class ShadowUtils
{
    public static Vector4 GetShadowBias(ref VisibleLight shadowLight, int shadowLightIndex, UniversalShadowData shadowData,
                                        Matrix4x4 lightProjectionMatrix, float shadowResolution) =>
        new Vector4(1.0f / lightProjectionMatrix.m00, shadowResolution, 0.0f, 0.0f);

    public static void SetupShadowCasterConstantBuffer(CommandBuffer cmd, ref VisibleLight shadowLight,
                                                       Vector4 shadowBias) =>
        cmd.SetGlobalVector(Shader.PropertyToID("_ShadowBias"), shadowBias);
}

public static class RenderingUtils
{
    public static bool ReAllocateHandleIfNeeded(ref RTHandle handle, in RenderTextureDescriptor descriptor,
                                                FilterMode filterMode = FilterMode.Point,
                                                TextureWrapMode wrapMode = TextureWrapMode.Repeat,
                                                int anisoLevel = 1, float mipMapBias = 0, string name = "")
    {
        if (handle != null && handle.What == name && handle.Descriptor.IsSame(descriptor)) return false;
        handle?.Release();
        handle = new RTHandle { What = name, Descriptor = descriptor };
        return true;
    }
}

public sealed partial class UniversalRenderer : ScriptableRenderer
{
    [OwnBehaviour] public UniversalRenderer() { }

    public static TextureHandle CreateRenderGraphTexture(RenderGraph renderGraph, RenderTextureDescriptor desc,
                                                         string name, bool clear,
                                                         FilterMode filterMode = FilterMode.Point,
                                                         TextureWrapMode wrapMode = TextureWrapMode.Clamp) =>
        renderGraph.Lend(name, desc);
}
