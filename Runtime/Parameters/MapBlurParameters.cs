using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Variance.technique.json; do not edit.
    /// <summary>Blur of a filtered shadow map.</summary>
    [System.Serializable]
    public struct MapBlurParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMapBlurParameters0");

        /// <summary>Standard deviation of the Gaussian. Unit: texels.</summary>
        [Tooltip("Standard deviation of the Gaussian. Unit: texels."), Range(0.0f, 4.0f)] public float deviation;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static MapBlurParameters Default => new MapBlurParameters
            { deviation = 1.5f };

        /// <summary>_PenumbraMapBlurParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(deviation, 0.0f, 4.0f), 0.0f, 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
