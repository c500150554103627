using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Pcss/PcssSpot.technique.json; do not edit.
    /// <summary>PCSS of a spot light: penumbra widths follow from the radius of its source.</summary>
    [System.Serializable]
    public struct PcssSpotParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPcssSpotParameters0");

        /// <summary>Samples of the blocker search, 1 to 64. Unit: fetches.</summary>
        [Tooltip("Samples of the blocker search, 1 to 64. Unit: fetches."), Range(1, 64)] public int blockerSamples;
        /// <summary>Samples of the filter, 1 to 64. Unit: fetches.</summary>
        [Tooltip("Samples of the filter, 1 to 64. Unit: fetches."), Range(1, 64)] public int filterSamples;
        /// <summary>Smallest filter and search radius. Unit: texels.</summary>
        [Tooltip("Smallest filter and search radius. Unit: texels."), Range(0.0f, 64.0f)] public float minFilterTexels;
        /// <summary>Largest penumbra width, from visibility 0 to 1; caps both radii. Unit: m.</summary>
        [Tooltip("Largest penumbra width, from visibility 0 to 1; caps both radii. Unit: m."), Range(0.0f, 1e+06f)] public float maxPenumbraMetres;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static PcssSpotParameters Default => new PcssSpotParameters
            { blockerSamples = 1, filterSamples = 1, minFilterTexels = 1.25f, maxPenumbraMetres = 100.0f };

        /// <summary>_PenumbraPcssSpotParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(blockerSamples, 1, 64),
            Bounded.Count(filterSamples, 1, 64), Bounded.OrLow(minFilterTexels, 0.0f, 64.0f),
            Bounded.OrLow(maxPenumbraMetres, 0.0f, 1e+06f));

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
