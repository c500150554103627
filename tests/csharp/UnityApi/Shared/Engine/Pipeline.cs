namespace UnityEngine
{
    public partial struct Bounds : IEquatable<Bounds> { public bool Equals(Bounds other) => true; }

    public sealed partial class Camera : Behaviour { public bool allowDynamicResolution { get; set; } }

    public partial struct Plane { }

    public sealed partial class Light : Behaviour
    {
        public LightShadows shadows { get; set; }
        public float shadowBias { get; set; }
        public float shadowNormalBias { get; set; }

        public float shadowStrength { get; set; } = 1.0f;

        public LightBakingOutput bakingOutput { get; set; }
    }

    public struct LightBakingOutput
    {
        public LightmapBakeType lightmapBakeType;
        public MixedLightingMode mixedLightingMode;
    }

    [System.Flags]
    public enum LightmapBakeType { Mixed = 1, Baked = 2, Realtime = 4 }

    public enum MixedLightingMode { IndirectOnly = 0, Subtractive = 1, Shadowmask = 2 }

    public enum ShadowmaskMode { Shadowmask = 0, DistanceShadowmask = 1 }

    public sealed partial class QualitySettings : Object
    {
        private QualitySettings() { }

        public static ShadowmaskMode shadowmaskMode { get; set; }
    }

    public static class ScalableBufferManager
    {
        public static float widthScaleFactor { get; [OwnBehaviour] set; } = 1.0f;
        public static float heightScaleFactor { get; [OwnBehaviour] set; } = 1.0f;
    }

    public sealed partial class GL
    {
        public static bool wireframe { get; set; }

        /// <summary>
        /// The projection is as on Direct3D: depth is reversed and goes to 0..1; y is turned for textures.
        /// </summary>
        public static Matrix4x4 GetGPUProjectionMatrix(Matrix4x4 proj, bool renderIntoTexture)
        {
            if (SystemInfo.usesReversedZBuffer)
            {
                proj.m20 = 0.5f * (proj.m30 - proj.m20);
                proj.m21 = 0.5f * (proj.m31 - proj.m21);
                proj.m22 = 0.5f * (proj.m32 - proj.m22);
                proj.m23 = 0.5f * (proj.m33 - proj.m23);
            }
            if (!renderIntoTexture || !SystemInfo.graphicsUVStartsAtTop) return proj;
            proj.m10 = -proj.m10;
            proj.m11 = -proj.m11;
            proj.m12 = -proj.m12;
            proj.m13 = -proj.m13;
            return proj;
        }
    }

    public sealed partial class RenderSettings : Object
    {
        private RenderSettings() { }

        public static Light sun { get; set; }
    }

    public sealed partial class SystemInfo
    {
        public static int graphicsShaderLevel { get; [OwnBehaviour] set; } = 50;
        public static Rendering.GraphicsDeviceType graphicsDeviceType => Device;
        public static bool supportsComputeShaders { get; [OwnBehaviour] set; } = true;
        public static int maxComputeWorkGroupSize { get; [OwnBehaviour] set; } = 1024;
        public static int maxComputeWorkGroupSizeX { get; [OwnBehaviour] set; } = 1024;
        public static int maxComputeWorkGroupSizeY { get; [OwnBehaviour] set; } = 1024;
        public static int maxComputeWorkGroupSizeZ { get; [OwnBehaviour] set; } = 64;
        public static bool supports3DRenderTextures { get; [OwnBehaviour] set; } = true;
        public static bool supports2DArrayTextures { get; [OwnBehaviour] set; } = true;
        public static int supportsMultisampledTextures { get; [OwnBehaviour] set; } = 1;
        public static Rendering.CopyTextureSupport copyTextureSupport { get; [OwnBehaviour] set; } =
            Rendering.CopyTextureSupport.Basic;
        public static int supportedRenderTargetCount { get; [OwnBehaviour] set; } = 8;
        public static bool graphicsUVStartsAtTop { get; [OwnBehaviour] set; } = true;
        public static bool usesReversedZBuffer { get; [OwnBehaviour] set; } = true;

        [OwnBehaviour] public static Rendering.GraphicsDeviceType Device { get; set; } =
            Rendering.GraphicsDeviceType.Vulkan;

        /// <summary>A format that this device cannot render to.</summary>
        [OwnBehaviour] public static Experimental.Rendering.GraphicsFormat? Unsupported { get; set; }

        /// <summary>The formats between whose texels the device does not interpolate.</summary>
        [OwnBehaviour]
        public static HashSet<Experimental.Rendering.GraphicsFormat> Unfiltered { get; } = new();
    }

    public class Time
    {
        public static int frameCount { get; [OwnBehaviour] set; }
        public static double timeAsDouble { get; [OwnBehaviour] set; }
    }
}

namespace UnityEngine.Rendering
{
    public abstract partial class RenderPipelineAsset : ScriptableObject { }

    public sealed partial class GraphicsSettings : Object
    {
        private GraphicsSettings() { }

        public static RenderPipelineAsset currentRenderPipeline { get; [OwnBehaviour] set; }
    }

    public partial struct CullingResults : IEquatable<CullingResults>
    {
        [OwnBehaviour] public bool HasCasters { get; set; }

        /// <summary>The view that was culled, by its radius, if it is not the camera's.</summary>
        [OwnBehaviour] public string Culled { get; set; }

        public bool GetShadowCasterBounds(int lightIndex, out Bounds outBounds)
        {
            outBounds = default;
            return HasCasters;
        }

        public bool Equals(CullingResults other) => HasCasters == other.HasCasters;
    }

    public struct VisibleLight : IEquatable<VisibleLight>
    {
        [OwnBehaviour] public Light Source { get; set; }

        public Light light => Source;

        public bool Equals(VisibleLight other) => ReferenceEquals(Source, other.Source);
    }

    public partial struct ScriptableRenderContext : IEquatable<ScriptableRenderContext>
    {
        [OwnBehaviour] public FakeDevice Device { get; set; }

        public void ExecuteCommandBuffer(CommandBuffer commandBuffer) => Device.Play(commandBuffer);

        public bool Equals(ScriptableRenderContext other) => Device == other.Device;
    }

    public static partial class RenderPipelineManager
    {
        public static event Action<ScriptableRenderContext, Camera> beginCameraRendering;
        public static event Action<ScriptableRenderContext, Camera> endCameraRendering;

        [OwnBehaviour]
        public static void BeginCamera(ScriptableRenderContext context, Camera camera) =>
            beginCameraRendering?.Invoke(context, camera);

        [OwnBehaviour]
        public static void EndCamera(ScriptableRenderContext context, Camera camera) =>
            endCameraRendering?.Invoke(context, camera);
    }
}

namespace Unity.Collections
{
    public partial struct NativeArray<T> : IEquatable<NativeArray<T>> where T : struct
    {
        [OwnBehaviour] public T[] Items { get; set; }

        public int Length => Items?.Length ?? 0;

        public T this[int index] { get => Items[index]; set => Items[index] = value; }

        public bool Equals(NativeArray<T> other) => Items == other.Items;
    }
}
