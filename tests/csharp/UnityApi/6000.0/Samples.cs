using Unity.Collections;

namespace UnityEditor
{
    [ReadFrom(At.Unity6, "engine", "Editor/Mono/Selection/Selection.bindings.cs")]
    public sealed partial class Selection { public static UnityEngine.GameObject activeGameObject { get; set; } }
}

namespace UnityEngine
{
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Scripting/RangeInt.cs")]
    public struct RangeInt
    {
        public int start, length;

        public RangeInt(int start, int length) => (this.start, this.length) = (start, length);
    }
}

namespace UnityEngine.Rendering
{
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/RenderPipeline/RenderPipelineAsset.cs")]
    public abstract partial class RenderPipelineAsset<TRenderPipeline> : RenderPipelineAsset
        where TRenderPipeline : RenderPipeline { }

    [ReadFrom(At.Unity6, "engine", "Runtime/Export/RenderPipeline/CullingParameters.cs")]
    public struct LightShadowCasterCullingInfo
    {
        public RangeInt splitRange;
        public BatchCullingProjectionType projectionType;
        public ushort splitExclusionMask;
    }

    [ReadFrom(At.Unity6, "engine", "Runtime/Export/RenderPipeline/CullingParameters.cs")]
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

    [ReadFrom(At.Unity6, "engine", "Runtime/Export/RenderPipeline/ShadowDrawingSettings.cs")]
    public struct ShadowDrawingSettings : IEquatable<ShadowDrawingSettings>
    {
        [OwnBehaviour] public int Split => splitIndex;

        public int splitIndex { get; set; }

        public ShadowDrawingSettings(CullingResults cullingResults, int lightIndex) { splitIndex = -1; }

        public bool Equals(ShadowDrawingSettings other) => Split == other.Split;
    }
}
