using System.Collections.Generic;
using System.IO;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Editor
{
    /// <summary>
    /// Lists shaders that would lose their shadow or receive another surface's, and renderers whose prepass excludes
    /// opaque layers, each with its fix: Window > Rendering > Penumbra Receivers.
    /// </summary>
    internal sealed class ReceiverWindow : EditorWindow
    {
        [SerializeField] private ReceiverSearch search = new ReceiverSearch();
        private string failure;  // reason why the last fix failed; null if it succeeded
        private Vector2 scroll;

        [MenuItem("Window/Rendering/Penumbra Receivers")]
        private static void Open()
        {
            ReceiverSearch search = GetWindow<ReceiverWindow>("Penumbra Receivers").search;
            if (!search.done || search.outdated) search.Run();
        }

        private void OnEnable() => EditorApplication.projectChanged += Outdate;

        private void OnDisable() => EditorApplication.projectChanged -= Outdate;

        private void Outdate()
        {
            search.outdated = true;
            Repaint();
        }

        private void OnGUI()
        {
            if (GUILayout.Button("Search the project"))
            {
                failure = null;
                search.Run();
            }
            if (!search.done)
            {
                EditorGUILayout.HelpBox("The project has not been searched yet.", MessageType.Info);
                return;
            }
            if (search.outdated)
                EditorGUILayout.HelpBox("The project has changed since this search.", MessageType.Info);
            ShowFound();
        }

        private void ShowFound()
        {
            List<(ScriptableRendererData renderer, int layers)> renderers = search.Renderers();
            int count = search.problems.Count + renderers.Count;
            EditorGUILayout.HelpBox(ReceiverReport.Summary(count), count == 0 ? MessageType.Info : MessageType.Warning);
            if (failure != null) EditorGUILayout.HelpBox(failure, MessageType.Error);
            scroll = EditorGUILayout.BeginScrollView(scroll);
            foreach ((ScriptableRendererData renderer, int layers) in renderers) Show(renderer, layers);
            search.problems.RemoveAll(problem => Mends(problem));
            EditorGUILayout.EndScrollView();
        }

        private static void Show(ScriptableRendererData renderer, int layers)
        {
            EditorGUILayout.LabelField(renderer.name, EditorStyles.boldLabel);
            EditorGUILayout.LabelField(PrepassLayers.Explanation(layers), EditorStyles.wordWrappedLabel);
            if (GUILayout.Button("Add these layers to the prepass")) PrepassLayers.Add(new SerializedObject(renderer));
        }

        // Whether the button has been pressed and the problem mended.
        private bool Mends(in ReceiverProblem problem)
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
            return failure == null;
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
