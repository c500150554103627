using UnityEngine;
using Object = UnityEngine.Object;

namespace Penumbra.Samples.PlanarAndBlobShadows
{
    /// <summary>A child object that draws a shadow instead of a surface, with a material of its own.</summary>
    internal sealed class ShadowCopy
    {
        private ShadowCopy(GameObject item, Mesh mesh, Material material)
        {
            Item = item;
            Mesh = mesh;
            Material = material;
        }

        internal GameObject Item { get; }

        internal Mesh Mesh { get; }

        internal Material Material { get; }

        /// <summary>Draws the mesh where the parent is; the shader moves its vertices into the shadow.</summary>
        internal static ShadowCopy Below(Transform parent, Mesh mesh, string shaderName)
        {
            Shader shader = Shader.Find(shaderName);
            if (shader == null)
                throw new System.InvalidOperationException("there is no shader \"" + shaderName + "\": import the whole sample, " +
                                                           "and put the shader into a Resources folder for builds");
            var item = new GameObject("Shadow") { hideFlags = HideFlags.HideAndDontSave };
            item.transform.SetParent(parent, false);
            item.AddComponent<MeshFilter>().sharedMesh = mesh;
            var material = new Material(shader) { name = "Shadow", hideFlags = HideFlags.HideAndDontSave };
            item.AddComponent<MeshRenderer>().sharedMaterial = material;
            return new ShadowCopy(item, mesh, material);
        }

        internal void Remove()
        {
            Remove(Item);
            Remove(Material);
        }

        /// <summary>Removes the copy with its mesh, where that was made for the copy alone.</summary>
        internal void RemoveWithMesh()
        {
            Remove();
            Remove(Mesh);
        }

        private static void Remove(Object item)
        {
            if (item == null) return;
            if (Application.isPlaying) Object.Destroy(item);
            else Object.DestroyImmediate(item);
        }
    }
}
