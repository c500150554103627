using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Samples.ShadowVolumes
{
    /// <summary>
    /// Draws the shadow volume of its mesh, from the scene's sun. The volume is built anew when the sun, the mesh or
    /// the object turns or changes its size; it moves with the object without being built. The mesh must be readable,
    /// and is taken as it is: without skinning and without holes of an alpha test.
    /// </summary>
    [ExecuteAlways]
    [RequireComponent(typeof(MeshFilter))]
    [AddComponentMenu("Penumbra Samples/Shadow Volume Caster")]
    public sealed class ShadowVolumeCaster : MonoBehaviour
    {
        private const int MostVerticesOf16Bits = 65535;

        [Tooltip("Of the shader Penumbra Samples/Shadow Volume Count.")]
        [SerializeField] private Material material;

        [Tooltip("How far the volume reaches along the light: beyond everything that it may shade.")]
        [Range(1.0f, 1000.0f)] [SerializeField] private float lengthMetres = 100.0f;

        private GameObject drawn;
        private Mesh volume;
        private Mesh builtOf;
        private Vector3 builtAlong;

        /// <summary>A material of the shader Penumbra Samples/Shadow Volume Count.</summary>
        public Material Material
        {
            get => material;
            set => material = value;
        }

        /// <summary>The volume that is drawn; null without a sun, a mesh or a material.</summary>
        internal Mesh Volume => volume;

        private void LateUpdate() { Refresh(); }

        private void OnDisable() { Remove(); }

        /// <summary>Builds the volume anew if it no longer fits the sun, the mesh and the object.</summary>
        internal void Refresh()
        {
            Light sun = RenderSettings.sun;
            Mesh mesh = gameObject.GetComponent<MeshFilter>().sharedMesh;
            if (sun == null || mesh == null || material == null)
            {
                Remove();
                return;
            }
            Vector3 way = transform.InverseTransformVector(sun.transform.forward * lengthMetres);
            if (mesh == builtOf && way.Equals(builtAlong)) return;
            Remove();
            builtOf = mesh;
            builtAlong = way;
            if (!mesh.isReadable)
                throw new InvalidOperationException("the mesh \"" + mesh.name + "\" of \"" + gameObject.name +
                                                    "\" is not readable: turn on Read/Write in its import settings");
            Draw(new ShadowVolumeBuilder(mesh.vertices, mesh.triangles, way));
        }

        private void Draw(ShadowVolumeBuilder built)
        {
            volume = new Mesh { name = "Shadow Volume", hideFlags = HideFlags.HideAndDontSave };
            if (built.Vertices.Count > MostVerticesOf16Bits) volume.indexFormat = IndexFormat.UInt32;
            volume.SetVertices(built.Vertices);
            volume.SetTriangles(built.Triangles, 0);
            volume.RecalculateBounds();
            drawn = new GameObject("Shadow Volume") { hideFlags = HideFlags.HideAndDontSave };
            drawn.transform.SetParent(transform, false);
            drawn.AddComponent<MeshFilter>().sharedMesh = volume;
            MeshRenderer renderer = drawn.AddComponent<MeshRenderer>();
            renderer.sharedMaterial = material;
            renderer.shadowCastingMode = ShadowCastingMode.Off;
            renderer.receiveShadows = false;
        }

        private void Remove()
        {
            builtOf = null;
            foreach (UnityEngine.Object item in new UnityEngine.Object[] { drawn, volume })
            {
                if (item == null) continue;
                if (Application.isPlaying) Destroy(item);
                else DestroyImmediate(item);
            }
            drawn = null;
            volume = null;
        }
    }
}
