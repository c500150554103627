using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>Window > Rendering > Penumbra Receivers: shaders that would lose their shadow, each with its fix.</summary>
    internal sealed class ReceiverWindow : EditorWindow
    {
        private List<ReceiverProblem> problems;
        private Vector2 scroll;

        [MenuItem("Window/Rendering/Penumbra Receivers")]
        private static void Open() => GetWindow<ReceiverWindow>("Penumbra Receivers");

        private void OnGUI()
        {
            if (GUILayout.Button("Look through the project") || problems == null) problems = ReceiverReport.Find();
            EditorGUILayout.HelpBox(problems.Count == 0
                                        ? "Every shader that takes the main light's shadow can read it from the screen."
                                        : problems.Count + " shaders cannot read the main light's shadow from the screen.",
                                    problems.Count == 0 ? MessageType.Info : MessageType.Warning);
            scroll = EditorGUILayout.BeginScrollView(scroll);
            bool changed = false;
            foreach (ReceiverProblem problem in problems) changed |= Show(problem);
            EditorGUILayout.EndScrollView();
            if (changed) problems = ReceiverReport.Find();
        }

        private static bool Show(in ReceiverProblem problem)
        {
            EditorGUILayout.LabelField(problem.path, EditorStyles.boldLabel);
            EditorGUILayout.LabelField(problem.Explanation, EditorStyles.wordWrappedLabel);
            if (!problem.CanApply || !GUILayout.Button(ButtonText(problem.fix))) return false;
            ReceiverReport.Apply(problem);
            return true;
        }

        private static string ButtonText(ReceiverFix fix) =>
            fix == ReceiverFix.AddKeyword ? "Add the keyword" : "Copy into the project and add the keyword";
    }
}
