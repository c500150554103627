using UnityEditor;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>Draws the component's fields, and one that takes the JSON file of a bake and fills them.</summary>
    [CustomEditor(typeof(FarShadowGround))]
    internal sealed class FarShadowGroundEditor : UnityEditor.Editor
    {
        private string problem;

        public override void OnInspectorGUI()
        {
            base.OnInspectorGUI();
            var label = new GUIContent("Assign Bake", "The JSON file of `penumbra bake heightfield` or `penumbra bake horizon`, with " +
                                                      "its pictures beside it: sets the pictures' import settings, assigns them, " +
                                                      "and sets corner, size and heights.");
            Object chosen = EditorGUILayout.ObjectField(label, null, typeof(TextAsset), false);
            if (chosen is TextAsset file) problem = BakeAssignment.Assign(file, (FarShadowGround)target);
            if (problem != null) EditorGUILayout.HelpBox(problem, MessageType.Error);
        }
    }
}
