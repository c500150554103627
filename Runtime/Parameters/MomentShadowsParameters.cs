using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/MomentShadows.technique.json; do not edit.
    /// <summary>Moment shadow maps.</summary>
    [System.Serializable]
    public struct MomentShadowsParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMomentShadowsParameters0");

        /// <summary>Share of a smooth distribution in the moments, against their rounding: 3e-7 with 32 bits, 6e-5 with 16.</summary>
        [Tooltip("Share of a smooth distribution in the moments, against their rounding: 3e-7 with 32 bits, 6e-5 with 16."), Range(1e-07f, 0.1f)] public float mix;
        /// <summary>Visibility up to which all is dark, which reduces light bleeding.</summary>
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static MomentShadowsParameters Default => new MomentShadowsParameters
            { mix = 3e-07f, bleeding = 0.2f };

        /// <summary>_PenumbraMomentShadowsParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(mix, 1e-07f, 0.1f),
            Bounded.OrLow(bleeding, 0.0f, 0.95f), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
