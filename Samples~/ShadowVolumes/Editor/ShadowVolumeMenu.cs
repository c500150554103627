using UnityEditor;
using UnityEngine;

namespace Penumbra.Samples.ShadowVolumes.Editor
{
    /// <summary>Builds the scene of shadow volumes in the open scene; undo removes it.</summary>
    internal static class ShadowVolumeMenu
    {
        [MenuItem("GameObject/Penumbra Samples/Shadow Volumes")]
        private static void Create()
        {
            var root = new GameObject("Penumbra Shadow Volumes");
            root.AddComponent<ShadowVolumeScene>().Build();
            Undo.RegisterCreatedObjectUndo(root, "Penumbra Shadow Volumes");
            Selection.activeGameObject = root;
        }
    }
}
