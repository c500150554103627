using Unity.Collections;

namespace UnityEngine.Rendering
{
    public abstract partial class RenderPipelineAsset { protected abstract RenderPipeline CreatePipeline(); }

    public abstract class RenderPipeline
    {
#if UNITY_6000_1_OR_NEWER
        [Obsolete("of 6000.1 and later")]
        protected virtual void Render(ScriptableRenderContext context, Camera[] cameras) { }
#else
        protected abstract void Render(ScriptableRenderContext context, Camera[] cameras);
#endif
        protected virtual void Render(ScriptableRenderContext context, List<Camera> cameras) { }
        protected static void BeginCameraRendering(ScriptableRenderContext context, Camera camera) { }
        protected static void EndCameraRendering(ScriptableRenderContext context, Camera camera) { }
        protected virtual void Dispose(bool disposing) { }

        [OwnBehaviour]
        public void RenderNow(ScriptableRenderContext context, Camera camera) =>
            Render(context, new List<Camera> { camera });

        [OwnBehaviour] public void DisposeNow() => Dispose(true);
    }

    public sealed partial class GraphicsSettings
    {
        public static bool useScriptableRenderPipelineBatching { get; set; }
        public static bool lightsUseLinearIntensity { get; set; }
    }

    public struct ScriptableCullingParameters : IEquatable<ScriptableCullingParameters>
    {
        public float shadowDistance { get; set; }
        public bool isOrthographic { get; set; }
        public Matrix4x4 cullingMatrix { get; set; }
        public CullingOptions cullingOptions { get; set; }
        public int cullingPlaneCount { get; set; }

        public void SetCullingPlane(int index, Plane plane) { }

        public bool Equals(ScriptableCullingParameters other) => shadowDistance == other.shadowDistance;
    }

    [Flags]
    public enum CullingOptions { None = 0, ForceEvenIfCameraIsNotActive = 1 << 0 }

    public struct ShadowSplitData : IEquatable<ShadowSplitData>
    {
        public Vector4 cullingSphere { get; set; }
        public float shadowCascadeBlendCullingFactor { get; set; }
        public int cullingPlaneCount { get; set; }

        public Plane GetCullingPlane(int index) => default;

        public bool Equals(ShadowSplitData other) => cullingSphere.Equals(other.cullingSphere);
    }

    public enum BatchCullingProjectionType { Unknown = 0, Perspective = 1, Orthographic = 2 }

    public partial struct CullingResults
    {
        /// <summary>The results that the next Cull() sees.</summary>
        [OwnBehaviour] public static CullingResults Next { get; set; }

        /// <summary>The numbers of the cascades that have no matrices.</summary>
        [OwnBehaviour] public static HashSet<int> Missing { get; } = new();

        [OwnBehaviour] public static VisibleLight[] Lights { get; set; } = new VisibleLight[0];

        public NativeArray<VisibleLight> visibleLights => new NativeArray<VisibleLight> { Items = Lights };

        /// <summary>A light that looks along +z, onto a square of twice its cascade's sphere.</summary>
        public bool ComputeDirectionalShadowMatricesAndCullingPrimitives(
            int activeLightIndex, int splitIndex, int splitCount, Vector3 splitRatio, int shadowResolution,
            float shadowNearPlaneOffset, out Matrix4x4 viewMatrix, out Matrix4x4 projMatrix,
            out ShadowSplitData shadowSplitData)
        {
            float radius = splitIndex + 1.0f;
            viewMatrix = Matrix4x4.identity;
            projMatrix = Matrix4x4.identity;
            projMatrix.m00 = 1.0f / radius;
            projMatrix.m11 = 1.0f / radius;
            projMatrix.m22 = -0.1f;
            shadowSplitData = new ShadowSplitData { cullingSphere = new Vector4(0.0f, 0.0f, 0.0f, radius) };
            return !Missing.Contains(splitIndex);
        }
    }

    public struct ShaderTagId : IEquatable<ShaderTagId>
    {
        public ShaderTagId(string name) { this.name = name; }

        public string name { get; }

        public bool Equals(ShaderTagId other) => name == other.name;
    }

    [Flags]
    public enum SortingCriteria
    {
        SortingLayer = 1 << 0, RenderQueue = 1 << 1, QuantizedFrontToBack = 1 << 3, OptimizeStateChanges = 1 << 4,
        CanvasOrder = 1 << 5, BackToFront = 1 << 2,
        CommonTransparent = SortingLayer | RenderQueue | BackToFront | OptimizeStateChanges,
        CommonOpaque = SortingLayer | RenderQueue | QuantizedFrontToBack | OptimizeStateChanges | CanvasOrder,
    }

    public struct SortingSettings : IEquatable<SortingSettings>
    {
        public SortingSettings(Camera camera) { criteria = default; }

        public SortingCriteria criteria { get; set; }

        public bool Equals(SortingSettings other) => criteria == other.criteria;
    }

    public struct DrawingSettings : IEquatable<DrawingSettings>
    {
        [OwnBehaviour] public string Pass { get; private set; }

        public Shader overrideShader { get; set; }
        public int overrideShaderPassIndex { get; set; }

        public DrawingSettings(ShaderTagId shaderPassName, SortingSettings sortingSettings)
        {
            Pass = shaderPassName.name;
            overrideShader = null;
            overrideShaderPassIndex = 0;
        }

        public void SetShaderPassName(int index, ShaderTagId shaderPassName) => Pass += ", " + shaderPassName.name;

        /// <summary>The tags are the objects' own; the program may be another.</summary>
        [OwnBehaviour]
        public string What => overrideShader == null ? Pass : Pass + " by " + overrideShader.PassNames[overrideShaderPassIndex];

        public bool Equals(DrawingSettings other) => Pass == other.Pass;
    }

    public struct RenderQueueRange : IEquatable<RenderQueueRange>
    {
        public static RenderQueueRange all => default;
        public static RenderQueueRange opaque => default;
        public static RenderQueueRange transparent => default;

        public bool Equals(RenderQueueRange other) => true;
    }

    public struct FilteringSettings : IEquatable<FilteringSettings>
    {
        public FilteringSettings(RenderQueueRange? renderQueueRange = null, int layerMask = ~0,
                                 uint renderingLayerMask = uint.MaxValue, int excludeMotionVectorObjects = 0) { }

        public bool Equals(FilteringSettings other) => true;
    }

    public struct RendererList { [OwnBehaviour] public string What { get; set; } }

    public struct RendererListParams : IEquatable<RendererListParams>
    {
        [OwnBehaviour] public string Pass { get; }
        [OwnBehaviour] public string Culled { get; }

        public RendererListParams(CullingResults cullingResults, DrawingSettings drawSettings,
                                  FilteringSettings filteringSettings)
        {
            Pass = CommandBuffer.Silent ? "" : drawSettings.What + cullingResults.Culled;
            Culled = cullingResults.Culled;
        }

        public bool Equals(RendererListParams other) => Pass == other.Pass;
    }

    public partial struct ScriptableRenderContext
    {
        public static void EmitWorldGeometryForSceneView(Camera cullingCamera) { }

        public CullingResults Cull(ref ScriptableCullingParameters parameters)
        {
            CullingResults results = CullingResults.Next;
            if (parameters.isOrthographic && !CommandBuffer.Silent)
                results.Culled = " of " + 1.0f / parameters.cullingMatrix.m00;
            return results;
        }

        public void SetupCameraProperties(Camera camera, bool stereoSetup = false) => Device.Target = "camera";

        public void Submit() { }

        public RendererList CreateRendererList(ref RendererListParams param) => new RendererList { What = param.Pass };

        public RendererList CreateShadowRendererList(ref ShadowDrawingSettings settings) =>
            new RendererList { What = "cascade " + settings.Split };

        public RendererList CreateSkyboxRendererList(Camera camera) => new RendererList { What = "sky" };
    }

    public partial struct RenderTargetIdentifier
    {
        public static implicit operator RenderTargetIdentifier(int nameID) =>
            new RenderTargetIdentifier { What = Shader.PropertyName(nameID) };
    }

    public partial class CommandBuffer
    {
        public string name { get; set; } = "";

        public void GetTemporaryRT(int nameID, int width, int height, int depthBuffer, FilterMode filter,
                                   RenderTextureFormat format) =>
            Texture(nameID, width + " x " + height);

        public void ReleaseTemporaryRT(int nameID) => Texture(nameID, null);

        public void SetRenderTarget(RenderTargetIdentifier rt, RenderBufferLoadAction loadAction,
                                    RenderBufferStoreAction storeAction) => Target(rt.What);

        /// <summary>Clears as part of drawing are told to the device, not as a draw.</summary>
        public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor) =>
            Record(static (device, what) => device.Uniforms["cleared"] = what,
                   clearDepth ? clearColor ? "depthcolour" : "depth" : clearColor ? "colour" : "");

        public void SetViewProjectionMatrices(Matrix4x4 view, Matrix4x4 proj) =>
            Record(static (device, told) => device.Uniforms["view"] = told, (view, proj));

        public void SetGlobalVectorArray(int nameID, Vector4[] values) => Uniform(nameID, values.Clone());

        public void DrawRendererList(RendererList rendererList) =>
            Record(static (device, what) => device.Draw(what, 0), rendererList.What);
    }
}

namespace Unity.Collections
{
    public enum Allocator { Temp = 2 }

    public enum NativeArrayOptions { UninitializedMemory = 0, ClearMemory = 1 }

    public partial struct NativeArray<T>
    {
        public NativeArray(int length, Allocator allocator, NativeArrayOptions options = NativeArrayOptions.ClearMemory) =>
            Items = new T[length];
    }
}
