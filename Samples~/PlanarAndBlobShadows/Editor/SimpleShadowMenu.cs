using UnityEditor;
using UnityEngine;

namespace Penumbra.Samples.PlanarAndBlobShadows.Editor
{
    /// <summary>Builds the scene of planar and blob shadows in the open scene; undo removes it.</summary>
    internal static class SimpleShadowMenu
    {
        [MenuItem("GameObject/Penumbra Samples/Planar and Blob Shadows")]
        private static void Create()
        {
            var root = new GameObject("Penumbra Planar and Blob Shadows");
            root.AddComponent<SimpleShadowScene>().Build();
            Undo.RegisterCreatedObjectUndo(root, "Penumbra Planar and Blob Shadows");
            Selection.activeGameObject = root;
        }
    }
}
