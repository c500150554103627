namespace UnityEngine.Rendering.Universal
{
    [AttributeUsage(AttributeTargets.Class)]
    public class DisallowMultipleRendererFeature : Attribute
    {
        public string customTitle { get; private set; }

        public DisallowMultipleRendererFeature(string customTitle = null) { this.customTitle = customTitle; }
    }

    public abstract class ScriptableRendererFeature : ScriptableObject, IDisposable
    {
        public bool isActive { get; private set; } = true;

        public abstract void Create();

        public abstract void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData);

        public void SetActive(bool active) => isActive = active;

        public void Dispose() => Dispose(true);

        protected virtual void Dispose(bool disposing) { }
    }

    public abstract partial class ScriptableRenderer : IDisposable
    {
        [OwnBehaviour] protected ScriptableRenderer() { }
        [OwnBehaviour] public List<ScriptableRenderPass> Queue { get; } = new();

        public void EnqueuePass(ScriptableRenderPass pass) => Queue.Add(pass);

        public void Dispose() { }
    }

    [Flags]
    public enum ScriptableRenderPassInput { None = 0, Depth = 1 << 0, Normal = 1 << 1, Color = 1 << 2 }

    public enum RenderPassEvent
    {
        AfterRenderingPrePasses = 200, BeforeRenderingGbuffer = 210, AfterRenderingGbuffer = 220,
        BeforeRenderingTransparents = 450, AfterRenderingTransparents = 500, BeforeRenderingPostProcessing = 550,
    }
}

namespace UnityEngine.Rendering.Universal
{
    public abstract partial class ScriptableRendererData : ScriptableObject
    {
        public List<ScriptableRendererFeature> rendererFeatures { get; } = new();
    }

    public enum CameraRenderType { Base, Overlay }

    public enum RenderingMode { Forward = 0, Deferred = 1, ForwardPlus = 2 }

    public enum DepthPrimingMode { Disabled = 0, Auto = 1, Forced = 2 }

    public partial class UniversalRendererData : ScriptableRendererData
    {
        public RenderingMode renderingMode { get; set; }
        public DepthPrimingMode depthPrimingMode { get; set; }
    }

    public partial class UniversalAdditionalLightData
    {
        public bool usePipelineSettings { get; set; }
        public SoftShadowQuality softShadowQuality { get; set; }
    }

    public enum SoftShadowQuality { UsePipelineSettings, Low, Medium, High }

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
