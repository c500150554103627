using UnityEditor;
using UnityEngine;

namespace Penumbra.Samples.Scenes.Editor
{
    /// <summary>Builds a sample scene in the open scene; undo removes it.</summary>
    internal static class SampleSceneMenu
    {
        private const string Menu = "GameObject/Penumbra Samples/";

        [MenuItem(Menu + "Contact")]
        private static void Contact() => Create(SampleSceneKind.Contact);

        [MenuItem(Menu + "Fence")]
        private static void Fence() => Create(SampleSceneKind.Fence);

        [MenuItem(Menu + "Foliage")]
        private static void Foliage() => Create(SampleSceneKind.Foliage);

        [MenuItem(Menu + "Cascades")]
        private static void Cascades() => Create(SampleSceneKind.Cascades);

        private static void Create(SampleSceneKind kind)
        {
            var root = new GameObject("Penumbra " + kind);
            SampleScene scene = root.AddComponent<SampleScene>();
            scene.Kind = kind;
            scene.Build();
            Undo.RegisterCreatedObjectUndo(root, "Penumbra " + kind);
            Selection.activeGameObject = root;
        }
    }
}
