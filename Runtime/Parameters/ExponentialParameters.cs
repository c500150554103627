using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Exponential.technique.json; do not edit.
    /// <summary>Exponential shadow maps.</summary>
    [System.Serializable]
    public struct ExponentialParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraExponentialParameters0");

        /// <summary>C of exp(c z), for depths z over the range of the map: at most 172 with 32 bits, 19 with 16.</summary>
        [Tooltip("C of exp(c z), for depths z over the range of the map: at most 172 with 32 bits, 19 with 16."), Range(1.0f, 172.0f)] public float exponent;
        /// <summary>Visibility up to which all is dark, which reduces light bleeding.</summary>
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static ExponentialParameters Default => new ExponentialParameters
            { exponent = 172.0f, bleeding = 0.2f };

        /// <summary>_PenumbraExponentialParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(exponent, 1.0f, 172.0f),
            Bounded.OrLow(bleeding, 0.0f, 0.95f), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
