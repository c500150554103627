using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Samples.ShadowVolumes
{
    /// <summary>
    /// Darkens the pixels that lie in shadow volumes, in every camera: it draws a triangle over the whole picture,
    /// after all other opaque objects. A scene needs one of these. It multiplies what is there, light of other sources
    /// included.
    /// </summary>
    [ExecuteAlways]
    [AddComponentMenu("Penumbra Samples/Shadow Volume Darkening")]
    public sealed class ShadowVolumeDarkening : MonoBehaviour
    {
        // The bounds are larger than any camera's frustum, so that the triangle is never culled.
        private const float BoundsMetres = 1.0e6f;

        [Tooltip("Of the shader Penumbra Samples/Shadow Volume Darken.")]
        [SerializeField] private Material material;

        private GameObject drawn;
        private Mesh triangle;

        /// <summary>A material of the shader Penumbra Samples/Shadow Volume Darken.</summary>
        public Material Material
        {
            get => material;
            set => material = value;
        }

        internal Mesh Triangle => triangle;

        private void LateUpdate() { Refresh(); }

        private void OnDisable() { Remove(); }

        internal void Refresh()
        {
            if (material == null || drawn != null) return;
            triangle = new Mesh { name = "Whole Picture", hideFlags = HideFlags.HideAndDontSave };
            triangle.SetVertices(new List<Vector3>
            {
                new Vector3(-1.0f, -1.0f, 0.0f), new Vector3(-1.0f, 3.0f, 0.0f), new Vector3(3.0f, -1.0f, 0.0f),
            });
            triangle.SetTriangles(new List<int> { 0, 1, 2 }, 0);
            triangle.bounds = new Bounds(Vector3.zero, Vector3.one * BoundsMetres);
            drawn = new GameObject("Shadow Volume Darkening") { hideFlags = HideFlags.HideAndDontSave };
            drawn.transform.SetParent(transform, false);
            drawn.AddComponent<MeshFilter>().sharedMesh = triangle;
            MeshRenderer renderer = drawn.AddComponent<MeshRenderer>();
            renderer.sharedMaterial = material;
            renderer.shadowCastingMode = ShadowCastingMode.Off;
            renderer.receiveShadows = false;
        }

        private void Remove()
        {
            foreach (Object item in new Object[] { drawn, triangle })
            {
                if (item == null) continue;
                if (Application.isPlaying) Destroy(item);
                else DestroyImmediate(item);
            }
            drawn = null;
            triangle = null;
        }
    }
}
