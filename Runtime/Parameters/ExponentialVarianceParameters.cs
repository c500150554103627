using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/ExponentialVariance.technique.json; do not edit.
    /// <summary>Exponential variance shadow maps.</summary>
    [System.Serializable]
    public struct ExponentialVarianceParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraExponentialVarianceParameters0");

        /// <summary>C of exp(c z), for depths z over the range of the map: at most 86 with 32 bits, 9 with 16.</summary>
        [Tooltip("C of exp(c z), for depths z over the range of the map: at most 86 with 32 bits, 9 with 16."), Range(1.0f, 86.0f)] public float positiveExponent;
        /// <summary>D of -exp(-d z), with the same limits.</summary>
        [Tooltip("D of -exp(-d z), with the same limits."), Range(1.0f, 86.0f)] public float negativeExponent;
        /// <summary>Visibility up to which all is dark, which reduces light bleeding.</summary>
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;
        /// <summary>Unit roundoff of the map's format: 2^-24 with 32 bits, 2^-11 with 16.</summary>
        [Tooltip("Unit roundoff of the map's format: 2^-24 with 32 bits, 2^-11 with 16."), Range(5.9604645e-08f, 0.01f)] public float precision;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static ExponentialVarianceParameters Default => new ExponentialVarianceParameters
            { positiveExponent = 80.0f, negativeExponent = 10.0f, bleeding = 0.2f, precision = 5.9604645e-08f };

        /// <summary>_PenumbraExponentialVarianceParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(positiveExponent, 1.0f, 86.0f),
            Bounded.OrLow(negativeExponent, 1.0f, 86.0f), Bounded.OrLow(bleeding, 0.0f, 0.95f),
            Bounded.OrLow(precision, 5.9604645e-08f, 0.01f));

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
