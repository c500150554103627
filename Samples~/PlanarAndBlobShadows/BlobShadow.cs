using System.Collections.Generic;
using UnityEngine;

namespace Penumbra.Samples.PlanarAndBlobShadows
{
    /// <summary>
    /// Draws the soft shadow that a ball in the place of its game object throws onto level ground, under a main light
    /// of some angular diameter. The ball is the object's own size at scale 1; turn off "Cast Shadows" of the object's
    /// renderer.
    /// </summary>
    [ExecuteAlways]
    [AddComponentMenu("Penumbra Samples/Blob Shadow")]
    public sealed class BlobShadow : MonoBehaviour
    {
        internal const string ShaderName = "Penumbra Samples/Blob Shadow";

        // The value is that of Shaders/BlobShadow.hlsl.
        private const float MeshHalfSide = 10.0f;

        [Tooltip("Radius of the ball in metres.")]
        [SerializeField] private float radiusMetres = 0.5f;

        [Tooltip("Height of the level ground, in metres.")]
        [SerializeField] private float groundMetres;

        [Tooltip("Full angle of the sun's disc in degrees: 0.53 for the real sun, several for a hazy sky.")]
        [Range(0.1f, 30.0f)]
        [SerializeField] private float angularDiameterDegrees = 5.0f;

        [Tooltip("Height of the ball's lowest point over the ground at which its shadow has faded, in metres; 0: it does not fade.")]
        [SerializeField] private float fadeMetres = 4.0f;

        [Tooltip("What the ground is multiplied by where the whole sun is hidden.")]
        [SerializeField] private Color shadowColor = new Color(0.35f, 0.38f, 0.45f, 1.0f);

        private ShadowCopy copy;

        public float RadiusMetres
        {
            get => radiusMetres;
            set
            {
                radiusMetres = value;
                Apply();
            }
        }

        internal ShadowCopy Copy => copy;

        internal void OnEnable()
        {
            if (copy != null) return;
            copy = ShadowCopy.Below(gameObject.transform, Square(), ShaderName);
            Apply();
        }

        internal void OnDisable()
        {
            copy?.RemoveWithMesh();
            copy = null;
        }

        internal void OnValidate() => Apply();

        private static Mesh Square()
        {
            var mesh = new Mesh { name = "Blob shadow", hideFlags = HideFlags.HideAndDontSave };
            mesh.SetVertices(new List<Vector3>
            {
                new Vector3(-MeshHalfSide, 0.0f, -MeshHalfSide), new Vector3(-MeshHalfSide, 0.0f, MeshHalfSide),
                new Vector3(MeshHalfSide, 0.0f, MeshHalfSide), new Vector3(MeshHalfSide, 0.0f, -MeshHalfSide),
            });
            mesh.SetTriangles(new List<int> { 0, 1, 2, 0, 2, 3 }, 0);
            mesh.RecalculateBounds();
            return mesh;
        }

        private void Apply()
        {
            if (copy == null) return;
            copy.Material.SetFloat("_RadiusMetres", radiusMetres);
            copy.Material.SetFloat("_GroundMetres", groundMetres);
            copy.Material.SetFloat("_HalfDiameter", 0.5f * angularDiameterDegrees * Mathf.Deg2Rad);
            copy.Material.SetFloat("_FadeMetres", fadeMetres);
            copy.Material.SetColor("_ShadowColor", shadowColor);
        }
    }
}
