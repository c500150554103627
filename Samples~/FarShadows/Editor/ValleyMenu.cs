using UnityEditor;
using UnityEngine;

namespace Penumbra.Samples.FarShadows.Editor
{
    /// <summary>Builds the valley in the open scene; undo removes it.</summary>
    internal static class ValleyMenu
    {
        [MenuItem("GameObject/Penumbra Samples/Far Shadows")]
        private static void Create()
        {
            var root = new GameObject("Penumbra Far Shadows");
            root.AddComponent<ValleyScene>().Build();
            Undo.RegisterCreatedObjectUndo(root, "Penumbra Far Shadows");
            Selection.activeGameObject = root;
        }
    }
}
