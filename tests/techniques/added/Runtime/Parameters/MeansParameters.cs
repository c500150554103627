using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Means.technique.json; do not edit.
    /// <summary>Of the test.</summary>
    [System.Serializable]
    public struct MeansParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMeansParameters0");

        /// <summary>Mip level.</summary>
        [Tooltip("Mip level."), Range(0, 1)] public int level;
        /// <summary>Of the result.</summary>
        [Tooltip("Of the result.")] public float scale;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static MeansParameters Default => new MeansParameters
            { level = 0, scale = 0.0f };

        /// <summary>_PenumbraMeansParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(level, 0, 1),
            Bounded.OrLow(scale, float.MinValue, float.MaxValue), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
