using System;
using UnityEngine;
using UnityEngine.Rendering;

// Written by `penumbra emit` from the manifests, *.technique.json; do not edit. Of each struct:
// Default: the manifest's defaults; a field without one is 0, or the low end of its range.
// VectorN: the uniform UniformN, each component clamped to its range; NaN gives the low end.
// SetGlobal: sets the uniforms for all later draws. It does not allocate.
namespace Penumbra
{
    /// <summary>Of the test.</summary>
    [Serializable]
    public struct MeansParameters
    {
        [Tooltip("Mip level."), Range(0, 1)] public int level;
        [Tooltip("Of the result.")] public float scale;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMeansParameters0");
        public static MeansParameters Default => new MeansParameters
            { level = 0, scale = 0.0f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(level, 0, 1),
            Bounded.OrLow(scale, float.MinValue, float.MaxValue), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
