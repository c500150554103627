using System.Collections.Generic;
using UnityEditor;
using UnityEditor.Rendering;

namespace Penumbra.Editor
{
    /// <summary>Draws the messages of an inspector, those that can be acted on with a button.</summary>
    internal static class AdviceBox
    {
        internal static void Show(IEnumerable<Advice> found)
        {
            foreach (Advice advice in found)
            {
                if (advice.action == null) EditorGUILayout.HelpBox(advice.text, advice.type);
                else CoreEditorUtils.DrawFixMeBox(advice.text, advice.type, advice.button, advice.action);
            }
        }
    }
}
