using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraPlanar.technique.json; do not edit.
    /// <summary>Shadows flattened onto a plane.</summary>
    [System.Serializable]
    public struct PlanarParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPlanarParameters0");

        /// <summary>Height over the plane of what casts no shadow any more; 0: no shadow fades. Unit: m.</summary>
        [Tooltip("Height over the plane of what casts no shadow any more; 0: no shadow fades. Unit: m."), Range(0.0f, 1000.0f)] public float planarFadeMetres;
        /// <summary>How far from the plane a surface may lie that receives its shadows. Unit: m.</summary>
        [Tooltip("How far from the plane a surface may lie that receives its shadows. Unit: m."), Range(0.0f, 10.0f)] public float planarToleranceMetres;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static PlanarParameters Default => new PlanarParameters
            { planarFadeMetres = 0.0f, planarToleranceMetres = 0.002f };

        /// <summary>_PenumbraPlanarParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(planarFadeMetres, 0.0f, 1000.0f),
            Bounded.OrLow(planarToleranceMetres, 0.0f, 10.0f), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
