using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Screen/EdgeDenoise.technique.json; do not edit.
    /// <summary>Smoothing of visibility in penumbrae.</summary>
    [System.Serializable]
    public struct DenoiseParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraDenoiseParameters0");

        /// <summary>Radius of the neighbourhood, 0 to 8. Unit: pixels.</summary>
        [Tooltip("Radius of the neighbourhood, 0 to 8. Unit: pixels."), Range(0, 8)] public int denoiseRadius;
        /// <summary>Plane distance threshold, in pixel footprints: a neighbour farther away counts as another surface. Unit: pixels.</summary>
        [Tooltip("Plane distance threshold, in pixel footprints: a neighbour farther away counts as another surface. Unit: pixels."), Range(0.0f, 1e+06f)] public float planeTolerance;
        /// <summary>Bilateral range threshold: a larger difference of visibility counts as an edge, not as noise.</summary>
        [Tooltip("Bilateral range threshold: a larger difference of visibility counts as an edge, not as noise."), Range(0.0f, 1.0f)] public float noiseAmplitude;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static DenoiseParameters Default => new DenoiseParameters
            { denoiseRadius = 2, planeTolerance = 2.0f, noiseAmplitude = 0.25f };

        /// <summary>_PenumbraDenoiseParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(denoiseRadius, 0, 8),
            Bounded.OrLow(planeTolerance, 0.0f, 1e+06f), Bounded.OrLow(noiseAmplitude, 0.0f, 1.0f), 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
