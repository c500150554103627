using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Layers.technique.json; do not edit.
    /// <summary>Of the test.</summary>
    [System.Serializable]
    public struct LayersParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraLayersParameters0");

        /// <summary>Of one surface.</summary>
        [Tooltip("Of one surface."), Range(0.0f, 1.0f)] public float opacity;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static LayersParameters Default => new LayersParameters
            { opacity = 0.0f };

        /// <summary>_PenumbraLayersParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(opacity, 0.0f, 1.0f), 0.0f, 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
