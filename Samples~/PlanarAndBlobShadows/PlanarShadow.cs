using UnityEngine;

namespace Penumbra.Samples.PlanarAndBlobShadows
{
    /// <summary>
    /// Draws the mesh of its game object a second time, flattened onto level ground along the main light: a hard shadow
    /// without a shadow map, for ground that is flat. Turn off "Cast Shadows" of the object's own renderer.
    /// </summary>
    [ExecuteAlways]
    [AddComponentMenu("Penumbra Samples/Planar Shadow")]
    public sealed class PlanarShadow : MonoBehaviour
    {
        internal const string ShaderName = "Penumbra Samples/Planar Shadow";

        [Tooltip("Height of the level ground, in metres.")]
        [SerializeField] private float groundMetres;

        [Tooltip("Height over the ground at which what casts the shadow casts none any more, in metres; 0: no shadow fades.")]
        [SerializeField] private float fadeMetres = 4.0f;

        [Tooltip("What the ground is multiplied by in the shadow.")]
        [SerializeField] private Color shadowColor = new Color(0.35f, 0.38f, 0.45f, 1.0f);

        private ShadowCopy copy;

        public float GroundMetres
        {
            get => groundMetres;
            set
            {
                groundMetres = value;
                Apply();
            }
        }

        public float FadeMetres
        {
            get => fadeMetres;
            set
            {
                fadeMetres = value;
                Apply();
            }
        }

        internal ShadowCopy Copy => copy;

        internal void OnEnable()
        {
            MeshFilter filter = gameObject.GetComponent<MeshFilter>();
            if (filter == null || copy != null) return;
            copy = ShadowCopy.Below(gameObject.transform, filter.sharedMesh, ShaderName);
            Apply();
        }

        internal void OnDisable()
        {
            copy?.Remove();
            copy = null;
        }

        internal void OnValidate() => Apply();

        private void Apply()
        {
            if (copy == null) return;
            copy.Material.SetFloat("_GroundMetres", groundMetres);
            copy.Material.SetFloat("_FadeMetres", fadeMetres);
            copy.Material.SetColor("_ShadowColor", shadowColor);
        }
    }
}
