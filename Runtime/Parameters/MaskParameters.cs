using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Screen/MaskBlur.technique.json; do not edit.
    /// <summary>How far the penumbra mask extends beyond the edges that it found.</summary>
    [System.Serializable]
    public struct MaskParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMaskParameters0");

        /// <summary>Largest penumbra width, from visibility 0 to 1, that the mask must cover; 0 for fixed filters. Unit: m.</summary>
        [Tooltip("Largest penumbra width, from visibility 0 to 1, that the mask must cover; 0 for fixed filters. Unit: m."), Range(0.0f, 1e+06f)] public float maskPenumbraMetres;
        /// <summary>Smallest filter radius that the mask must cover, in texels of the shadow map. Unit: texels.</summary>
        [Tooltip("Smallest filter radius that the mask must cover, in texels of the shadow map. Unit: texels."), Range(0.0f, 64.0f)] public float maskFilterTexels;
        /// <summary>Largest radius of the dilation, in texels of the mask. Unit: texels.</summary>
        [Tooltip("Largest radius of the dilation, in texels of the mask. Unit: texels."), Range(0, 1024)] public int maskLargestRadius;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static MaskParameters Default => new MaskParameters
            { maskPenumbraMetres = 100.0f, maskFilterTexels = 2.0f, maskLargestRadius = 32 };

        /// <summary>_PenumbraMaskParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(maskPenumbraMetres, 0.0f, 1e+06f),
            Bounded.OrLow(maskFilterTexels, 0.0f, 64.0f), Bounded.Count(maskLargestRadius, 0, 1024), 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
