using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Variance.technique.json; do not edit.
    /// <summary>Variance shadow maps.</summary>
    [System.Serializable]
    public struct VarianceParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraVarianceParameters0");

        /// <summary>Visibility up to which all is dark, which reduces light bleeding.</summary>
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;
        /// <summary>Unit roundoff of the map's format: 2^-24 with 32 bits, 2^-11 with 16.</summary>
        [Tooltip("Unit roundoff of the map's format: 2^-24 with 32 bits, 2^-11 with 16."), Range(5.9604645e-08f, 0.01f)] public float precision;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static VarianceParameters Default => new VarianceParameters
            { bleeding = 0.2f, precision = 5.9604645e-08f };

        /// <summary>_PenumbraVarianceParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(bleeding, 0.0f, 0.95f),
            Bounded.OrLow(precision, 5.9604645e-08f, 0.01f), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
