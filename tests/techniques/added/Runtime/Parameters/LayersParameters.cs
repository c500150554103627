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
    public struct LayersParameters
    {
        [Tooltip("Of one surface."), Range(0.0f, 1.0f)] public float opacity;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraLayersParameters0");
        public static LayersParameters Default => new LayersParameters
            { opacity = 0.0f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(opacity, 0.0f, 1.0f), 0.0f, 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
