using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/VarianceMultisampled.technique.json; do not edit.
    /// <summary>Samples of a multisampled shadow map.</summary>
    [System.Serializable]
    public struct MapSampleParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMapSampleParameters0");

        /// <summary>Samples of a texel: 2, 4 or 8.</summary>
        [Tooltip("Samples of a texel: 2, 4 or 8."), Range(2, 8)] public int mapSamples;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static MapSampleParameters Default => new MapSampleParameters
            { mapSamples = 4 };

        /// <summary>_PenumbraMapSampleParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(mapSamples, 2, 8), 0.0f, 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
