using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Layers.technique.json; do not edit.
    /// <summary>Of the test.</summary>
    [Serializable]
    public struct LayersParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraLayersParameters0");

        /// <summary>Of one surface.</summary>
        [Tooltip("Of one surface.")]
        [Range(0.0f, 1.0f)]
        public float opacity;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static LayersParameters Default => new LayersParameters
        {
            opacity = 0.0f,
        };

        /// <summary>The value of _PenumbraLayersParameters0. Components are clamped to their ranges; NaN gives the low end.</summary>
        public Vector4 Vector0 =>
                new Vector4(Bounded.OrLow(opacity, 0.0f, 1.0f),
                            0.0f,
                            0.0f,
                            0.0f);

        /// <summary>The value of one of this struct's uniforms; false for other uniforms.</summary>
        internal bool TryGet(int uniform, out Vector4 vector)
        {
            if (uniform == Uniform0)
            {
                vector = Vector0;
                return true;
            }
            vector = default;
            return false;
        }

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
        }
    }
}
