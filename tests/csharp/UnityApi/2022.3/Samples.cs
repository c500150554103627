namespace UnityEditor
{
    public sealed partial class Selection { public static UnityEngine.GameObject activeGameObject { get; set; } }
}

namespace UnityEngine.Rendering
{
    public struct ShadowDrawingSettings : IEquatable<ShadowDrawingSettings>
    {
        [OwnBehaviour] public int Split => (int)splitData.cullingSphere.w - 1;

        public ShadowSplitData splitData { get; set; }

        public ShadowDrawingSettings(CullingResults cullingResults, int lightIndex,
                                     BatchCullingProjectionType projectionType) => splitData = default;

        public bool Equals(ShadowDrawingSettings other) => Split == other.Split;
    }
}
