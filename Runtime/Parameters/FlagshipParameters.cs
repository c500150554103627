using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraFlagship.technique.json; do not edit.
    /// <summary>How finely the flagship filters what it does not decide for tiles.</summary>
    [Serializable]
    public struct FlagshipParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraFlagshipParameters0");

        /// <summary>Cells of the shadow map, or fewer, from the middle of a wide penumbra's filter to its edge, 3 to 5. Unit: cells.</summary>
        [Tooltip("Cells of the shadow map, or fewer, from the middle of a wide penumbra's filter to its edge, 3 to 5. Unit: cells.")]
        [Range(3, 5)]
        public int filterCells;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static FlagshipParameters Default => new FlagshipParameters
        {
            filterCells = 5,
        };

        /// <summary>The value of _PenumbraFlagshipParameters0. Components are clamped to their ranges; NaN gives the low end.</summary>
        public Vector4 Vector0 =>
                new Vector4(Bounded.Count(filterCells, 3, 5),
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
