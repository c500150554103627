using Penumbra.UnityApi;
using UnityEngine;

namespace UnityEditor.Rendering
{
    [ReadFrom(At.Core14, "core", "Editor/Volume/SerializedDataParameter.cs")]
    [ReadFrom(At.Core17, "core", "Editor/Volume/SerializedDataParameter.cs")]
    public sealed class SerializedDataParameter
    {
        internal SerializedDataParameter() { }
    }

    [ReadFrom(At.Core14, "core", "Editor/Volume/VolumeComponentEditor.cs")]
    [ReadFrom(At.Core17, "core", "Editor/Volume/VolumeComponentEditor.cs")]
    public partial class VolumeComponentEditor : Editor
    {
        public virtual void OnEnable() { }
        public override void OnInspectorGUI() { }
        public virtual GUIContent GetDisplayTitle() => new GUIContent(GetType().Name, "");

        protected SerializedDataParameter Unpack(SerializedProperty property) => new SerializedDataParameter();
        protected bool PropertyField(SerializedDataParameter property, GUIContent title) => false;
    }
}
