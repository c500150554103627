using Unity.Collections;

namespace UnityEditor
{
    public sealed partial class Selection { public static UnityEngine.GameObject activeGameObject { get; set; } }
}

namespace UnityEngine
{
    public struct RangeInt
    {
        public int start, length;

        public RangeInt(int start, int length) => (this.start, this.length) = (start, length);
    }
}

namespace UnityEngine.Rendering
{
    public abstract partial class RenderPipelineAsset<TRenderPipeline> : RenderPipelineAsset
        where TRenderPipeline : RenderPipeline { }

    public struct LightShadowCasterCullingInfo
    {
        public RangeInt splitRange;
        public BatchCullingProjectionType projectionType;
        public ushort splitExclusionMask;
    }

    public struct ShadowCastersCullingInfos
    {
        public NativeArray<ShadowSplitData> splitBuffer;
        public NativeArray<LightShadowCasterCullingInfo> perLightInfos;
    }

    public partial struct ScriptableRenderContext
    {
        /// <summary>The views that casters were last culled for.</summary>
        [OwnBehaviour] public static ShadowCastersCullingInfos Culled { get; set; }

        public void CullShadowCasters(CullingResults cullingResults, ShadowCastersCullingInfos infos) => Culled = infos;
    }

    public struct ShadowDrawingSettings : IEquatable<ShadowDrawingSettings>
    {
        [OwnBehaviour] public int Split => splitIndex;

        public int splitIndex { get; set; }

        public ShadowDrawingSettings(CullingResults cullingResults, int lightIndex) { splitIndex = -1; }

        public bool Equals(ShadowDrawingSettings other) => Split == other.Split;
    }
}
