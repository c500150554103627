using Unity.Collections;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Rendering.Universal;

public sealed partial class UniversalRenderPipeline { private UniversalRenderPipeline() { } }

public struct RenderingData
{
    public CullingResults cullResults;
    public CameraData cameraData;
    public LightData lightData;
    public ShadowData shadowData;
}

public struct LightData
{
    public int mainLightIndex;
    public bool supportsMixedLighting;
    public NativeArray<VisibleLight> visibleLights;
}

public struct ShadowData
{
    public bool supportsMainLightShadows;
    public int mainLightShadowmapWidth, mainLightShadowmapHeight, mainLightShadowCascadesCount;
    public Vector3 mainLightShadowCascadesSplit;
    public float mainLightShadowCascadeBorder;
    public bool supportsSoftShadows;
}

public struct CameraData
{
    [OwnBehaviour] public Matrix4x4[] Views, Projections;

    public Camera camera;
    public RenderTexture targetTexture;
    public RenderTextureDescriptor cameraTargetDescriptor;
    public CameraRenderType renderType;
    public CameraType cameraType;
    public float maxShadowDistance;

    public XRPass xr { get; internal set; }

    public Matrix4x4 GetViewMatrix(int viewIndex = 0) => Views[viewIndex];
    public Matrix4x4 GetProjectionMatrix(int viewIndex = 0) => Projections[viewIndex];

    [OwnBehaviour] public void SetXr(XRPass pass) => xr = pass;
}

public abstract partial class ScriptableRenderPass
{
    [OwnBehaviour] public RTHandle Target { get; private set; }

    public RenderPassEvent renderPassEvent { get; set; }
    public ScriptableRenderPassInput input { get; private set; }
    protected internal ProfilingSampler profilingSampler { get; set; }

    public void ConfigureInput(ScriptableRenderPassInput passInput) => input = passInput;
    public void ConfigureTarget(RTHandle colorAttachment) => Target = colorAttachment;
    public void ConfigureClear(ClearFlag clearFlag, Color clearColor) { }

    public virtual void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData) { }
    public abstract void Execute(ScriptableRenderContext context, ref RenderingData renderingData);
}

public static class ShadowUtils
{
    public static Vector4 GetShadowBias(ref VisibleLight shadowLight, int shadowLightIndex, ref ShadowData shadowData,
                                        Matrix4x4 lightProjectionMatrix, float shadowResolution) =>
        new Vector4(1.0f / lightProjectionMatrix.m00, shadowResolution, 0.0f, 0.0f);

    public static void SetupShadowCasterConstantBuffer(CommandBuffer cmd, ref VisibleLight shadowLight,
                                                       Vector4 shadowBias) =>
        cmd.SetGlobalVector(Shader.PropertyToID("_ShadowBias"), shadowBias);
}

public static class RenderingUtils
{
    public static bool ReAllocateIfNeeded(ref RTHandle handle, in RenderTextureDescriptor descriptor,
                                          FilterMode filterMode = FilterMode.Point,
                                          TextureWrapMode wrapMode = TextureWrapMode.Repeat,
                                          bool isShadowMap = false, int anisoLevel = 1, float mipMapBias = 0,
                                          string name = "")
    {
        if (handle != null && handle.What == name && handle.Descriptor.IsSame(descriptor)) return false;
        handle?.Release();
        handle = new RTHandle { What = name, Descriptor = descriptor };
        return true;
    }
}

public abstract partial class ScriptableRenderer
{
    public class RenderingFeatures { public bool msaa { get; set; } = true; }

    public RenderingFeatures supportedRenderingFeatures { get; set; } = new RenderingFeatures();
}
