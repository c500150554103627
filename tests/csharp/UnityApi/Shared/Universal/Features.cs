namespace UnityEngine.Rendering.Universal
{
    [ReadFrom(At.Universal, "universal", "Runtime/RendererFeatures/DisallowMultipleRendererFeature.cs")]
    [AttributeUsage(AttributeTargets.Class)]
    public class DisallowMultipleRendererFeature : Attribute
    {
        public string customTitle { get; private set; }

        public DisallowMultipleRendererFeature(string customTitle = null) { this.customTitle = customTitle; }
    }

    [ReadFrom(At.Universal, "universal", "Runtime/ScriptableRendererFeature.cs")]
    public abstract class ScriptableRendererFeature : ScriptableObject, IDisposable
    {
        public bool isActive { get; private set; } = true;

        public abstract void Create();

        public abstract void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData);

        public void SetActive(bool active) => isActive = active;

        public void Dispose() => Dispose(true);

        protected virtual void Dispose(bool disposing) { }
    }

    [ReadFrom(At.Universal, "universal", "Runtime/ScriptableRenderer.cs")]
    public abstract partial class ScriptableRenderer : IDisposable
    {
        [OwnBehaviour] protected ScriptableRenderer() { }
        [OwnBehaviour] public List<ScriptableRenderPass> Queue { get; } = new();

        public void EnqueuePass(ScriptableRenderPass pass) => Queue.Add(pass);

        public void Dispose() { }
    }

    [ReadFrom(At.Universal, "universal", "Runtime/Passes/ScriptableRenderPass.cs")]
    [Flags]
    public enum ScriptableRenderPassInput { None = 0, Depth = 1 << 0, Normal = 1 << 1, Color = 1 << 2 }

    [ReadFrom(At.Universal, "universal", "Runtime/Passes/ScriptableRenderPass.cs")]
    public enum RenderPassEvent
    {
        AfterRenderingPrePasses = 200, BeforeRenderingGbuffer = 210, AfterRenderingGbuffer = 220,
        BeforeRenderingTransparents = 450, AfterRenderingTransparents = 500, BeforeRenderingPostProcessing = 550,
    }
}

namespace UnityEngine.Rendering.Universal
{
    [ReadFrom(At.Universal, "universal", "Runtime/ScriptableRendererData.cs")]
    public abstract partial class ScriptableRendererData : ScriptableObject
    {
        public List<ScriptableRendererFeature> rendererFeatures { get; } = new();
    }

    [ReadFrom(At.Universal, "universal", "Runtime/UniversalAdditionalCameraData.cs")]
    public enum CameraRenderType { Base, Overlay }

    [ReadFrom(At.Universal, "universal", "Runtime/UniversalRenderer.cs")]
    public enum RenderingMode { Forward = 0, Deferred = 1, ForwardPlus = 2 }

    [ReadFrom(At.Universal, "universal", "Runtime/UniversalRenderer.cs")]
    public enum DepthPrimingMode { Disabled = 0, Auto = 1, Forced = 2 }

    [ReadFrom(At.Universal, "universal", "Runtime/UniversalRendererData.cs")]
    public partial class UniversalRendererData : ScriptableRendererData
    {
        public RenderingMode renderingMode { get; set; }
        public DepthPrimingMode depthPrimingMode { get; set; }
    }

    [ReadFrom(At.Universal, "universal", "Runtime/UniversalAdditionalLightData.cs")]
    public partial class UniversalAdditionalLightData
    {
        public bool usePipelineSettings { get; set; }
        public SoftShadowQuality softShadowQuality { get; set; }
    }

    [ReadFrom(At.Universal, "universal", "Runtime/Data/UniversalRenderPipelineAsset.cs")]
    public enum SoftShadowQuality { UsePipelineSettings, Low, Medium, High }

    [ReadFrom(At.Universal, "universal", "Runtime/Data/UniversalRenderPipelineAsset.cs")]
    public partial class UniversalRenderPipelineAsset : RenderPipelineAsset
    {
        // Unity serializes this field.
        private bool m_MainLightShadowsSupported;

        public bool supportsMainLightShadows
        {
            get => m_MainLightShadowsSupported;
            [OwnBehaviour] set => m_MainLightShadowsSupported = value;
        }
        public int mainLightShadowmapResolution { get; [OwnBehaviour] set; }
        public float shadowDepthBias { get; set; }
        public float shadowNormalBias { get; set; }

        /// <summary>The quality, which is internal in Unity, too.</summary>
        [OwnBehaviour] internal SoftShadowQuality softShadowQuality { get; set; } = SoftShadowQuality.Medium;

        [OwnBehaviour] public void SetSoftShadowQuality(SoftShadowQuality quality) => softShadowQuality = quality;
    }
}
