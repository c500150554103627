using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Peers/PcssHdrp.technique.json; do not edit.
    /// <summary>PCSS (HDRP): with the rules and parameters of Unity's HDRP.</summary>
    [System.Serializable]
    public struct PcssHdrpParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPcssHdrpParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraPcssHdrpParameters1");

        /// <summary>Samples of the blocker search, 1 to 64. Unit: fetches.</summary>
        [Tooltip("Samples of the blocker search, 1 to 64. Unit: fetches."), Range(1, 64)] public int blockerSamples;
        /// <summary>Samples of the filter, 1 to 64. Unit: fetches.</summary>
        [Tooltip("Samples of the filter, 1 to 64. Unit: fetches."), Range(1, 64)] public int filterSamples;
        /// <summary>Radial distribution of the search samples: 1 uniform over the area, 2 density 1/r, 4 density r^-1.5.</summary>
        [Tooltip("Radial distribution of the search samples: 1 uniform over the area, 2 density 1/r, 4 density r^-1.5."), Range(1.0f, 8.0f)] public float blockerClump;
        /// <summary>Smallest filter and search radius. Unit: texels.</summary>
        [Tooltip("Smallest filter and search radius. Unit: texels."), Range(0.0f, 64.0f)] public float minFilterTexels;
        /// <summary>Caps the distance of blockers at this / (2 tan(a/2)) for a light of angular diameter a. Unit: m.</summary>
        [Tooltip("Caps the distance of blockers at this / (2 tan(a/2)) for a light of angular diameter a. Unit: m."), Range(0.0f, 1e+06f)] public float maxPenumbraMetres;
        /// <summary>Largest depth offset of the cone. Unit: m.</summary>
        [Tooltip("Largest depth offset of the cone. Unit: m."), Range(0.0f, 1e+06f)] public float maxSamplingMetres;
        /// <summary>Tangent of half the blocker search's angular diameter.</summary>
        [Tooltip("Tangent of half the blocker search's angular diameter."), Range(0.0f, 1000.0f)] public float searchTanHalf;
        /// <summary>Tangent of half the angular diameter of the cone below the smallest filter radius.</summary>
        [Tooltip("Tangent of half the angular diameter of the cone below the smallest filter radius."), Range(0.0f, 1000.0f)] public float minFilterTanHalf;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static PcssHdrpParameters Default => new PcssHdrpParameters
            { blockerSamples = 1, filterSamples = 1, blockerClump = 1.0f, minFilterTexels = 0.0f,
              maxPenumbraMetres = 0.0f, maxSamplingMetres = 0.0f, searchTanHalf = 0.0f, minFilterTanHalf = 0.0f };

        /// <summary>_PenumbraPcssHdrpParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(blockerSamples, 1, 64),
            Bounded.Count(filterSamples, 1, 64), Bounded.OrLow(blockerClump, 1.0f, 8.0f),
            Bounded.OrLow(minFilterTexels, 0.0f, 64.0f));
        /// <summary>_PenumbraPcssHdrpParameters1, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(maxPenumbraMetres, 0.0f, 1e+06f),
            Bounded.OrLow(maxSamplingMetres, 0.0f, 1e+06f), Bounded.OrLow(searchTanHalf, 0.0f, 1000.0f),
            Bounded.OrLow(minFilterTanHalf, 0.0f, 1000.0f));

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }
}
