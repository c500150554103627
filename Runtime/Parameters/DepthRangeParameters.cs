using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/SingleLoop/SingleLoop.technique.json; do not edit.
    /// <summary>Radii of the map of nearest and farthest depths around each texel.</summary>
    [System.Serializable]
    public struct DepthRangeParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraDepthRangeParameters0");

        /// <summary>Radius in cascade 0, in texels of the quarter-resolution map: 8 are 32 texels of the shadow map. Unit: texels.</summary>
        [Tooltip("Radius in cascade 0, in texels of the quarter-resolution map: 8 are 32 texels of the shadow map. Unit: texels."), Range(0, 16)] public int dilation0;
        /// <summary>The same in cascade 1. Unit: texels.</summary>
        [Tooltip("The same in cascade 1. Unit: texels."), Range(0, 16)] public int dilation1;
        /// <summary>The same in cascade 2. Unit: texels.</summary>
        [Tooltip("The same in cascade 2. Unit: texels."), Range(0, 16)] public int dilation2;
        /// <summary>The same in cascade 3. Unit: texels.</summary>
        [Tooltip("The same in cascade 3. Unit: texels."), Range(0, 16)] public int dilation3;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static DepthRangeParameters Default => new DepthRangeParameters
            { dilation0 = 8, dilation1 = 4, dilation2 = 3, dilation3 = 0 };

        /// <summary>_PenumbraDepthRangeParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(dilation0, 0, 16), Bounded.Count(dilation1, 0, 16),
            Bounded.Count(dilation2, 0, 16), Bounded.Count(dilation3, 0, 16));

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
