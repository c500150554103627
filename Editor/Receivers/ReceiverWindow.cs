using System.Collections.Generic;
using System.IO;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Editor
{
    /// <summary>
    /// Window > Rendering > Penumbra Receivers: shaders that would lose their shadow or receive another surface's,
    /// and renderers whose prepass excludes opaque layers, each with its fix.
    /// </summary>
    internal sealed class ReceiverWindow : EditorWindow
    {
        private List<ReceiverProblem> problems;
        private List<(ScriptableRendererData renderer, int layers)> renderers;
        private string failure;  // of the last fix; null if it succeeded
        private Vector2 scroll;

        [MenuItem("Window/Rendering/Penumbra Receivers")]
        private static void Open() => GetWindow<ReceiverWindow>("Penumbra Receivers");

        private void Look()
        {
            problems = ReceiverReport.Find();
            renderers = PrepassLayers.In(FeaturesInProject.Renderers());
        }

        private void OnGUI()
        {
            if (GUILayout.Button("Search the project") || problems == null)
            {
                failure = null;
                Look();
            }
            int count = problems.Count + renderers.Count;
            EditorGUILayout.HelpBox(ReceiverReport.Summary(count), count == 0 ? MessageType.Info : MessageType.Warning);
            if (failure != null) EditorGUILayout.HelpBox(failure, MessageType.Error);
            scroll = EditorGUILayout.BeginScrollView(scroll);
            bool changed = false;
            foreach ((ScriptableRendererData renderer, int layers) in renderers) changed |= Show(renderer, layers);
            foreach (ReceiverProblem problem in problems) changed |= Show(problem);
            EditorGUILayout.EndScrollView();
            if (changed) Look();
        }

        private static bool Show(ScriptableRendererData renderer, int layers)
        {
            EditorGUILayout.LabelField(renderer.name, EditorStyles.boldLabel);
            EditorGUILayout.LabelField(PrepassLayers.Explanation(layers), EditorStyles.wordWrappedLabel);
            if (!GUILayout.Button("Add these layers to the prepass")) return false;
            PrepassLayers.Add(new SerializedObject(renderer));
            return true;
        }

        private bool Show(in ReceiverProblem problem)
        {
            EditorGUILayout.LabelField(problem.path, EditorStyles.boldLabel);
            EditorGUILayout.LabelField(problem.Explanation, EditorStyles.wordWrappedLabel);
            if (!problem.CanApply || !GUILayout.Button(ButtonText(problem.fix))) return false;
            failure = null;
            try
            {
                ReceiverReport.Apply(problem);
            }
            catch (IOException kept)
            {
                failure = kept.Message;
            }
            return true;
        }

        private static string ButtonText(ReceiverFix fix)
        {
            switch (fix)
            {
                case ReceiverFix.AddKeyword: return "Add the keyword";
                case ReceiverFix.AddPasses: return "Add the passes";
                default: return "Copy into the project and add the missing parts";
            }
        }
    }
}
