using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Fixed/FixedPcf.technique.json; do not edit.
    /// <summary>Kernel of N x N bilinear comparisons with equal weights.</summary>
    [System.Serializable]
    public struct BoxParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraBoxParameters0");

        /// <summary>N, odd, 1 to 9. Unit: taps.</summary>
        [Tooltip("N, odd, 1 to 9. Unit: taps."), Range(1, 9)] public int tapsPerSide;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static BoxParameters Default => new BoxParameters
            { tapsPerSide = 1 };

        /// <summary>_PenumbraBoxParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(tapsPerSide, 1, 9), 0.0f, 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
