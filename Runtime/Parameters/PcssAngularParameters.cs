using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Pcss/PcssAngular.technique.json; do not edit.
    /// <summary>PCSS: penumbra widths follow from the light's angular diameter.</summary>
    [System.Serializable]
    public struct PcssAngularParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPcssAngularParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraPcssAngularParameters1");

        /// <summary>Samples of the blocker search, 1 to 64. Unit: fetches.</summary>
        [Tooltip("Samples of the blocker search, 1 to 64. Unit: fetches."), Range(1, 64)] public int blockerSamples;
        /// <summary>Samples of the filter, 1 to 64. Unit: fetches.</summary>
        [Tooltip("Samples of the filter, 1 to 64. Unit: fetches."), Range(1, 64)] public int filterSamples;
        /// <summary>Radial distribution of the search samples: 0 equally many per octave of radius, 1 uniform over the area, 2 density 1/r.</summary>
        [Tooltip("Radial distribution of the search samples: 0 equally many per octave of radius, 1 uniform over the area, 2 density 1/r."), Range(0.0f, 8.0f)] public float blockerClump;
        /// <summary>Smallest filter and search radius. Unit: texels.</summary>
        [Tooltip("Smallest filter and search radius. Unit: texels."), Range(0.0f, 64.0f)] public float minFilterTexels;
        /// <summary>Largest penumbra width, from visibility 0 to 1; caps both radii. Unit: m.</summary>
        [Tooltip("Largest penumbra width, from visibility 0 to 1; caps both radii. Unit: m."), Range(0.0f, 1e+06f)] public float maxPenumbraMetres;
        /// <summary>Height of the light's cone above the receiver, beyond which it is a cylinder. Unit: m.</summary>
        [Tooltip("Height of the light's cone above the receiver, beyond which it is a cylinder. Unit: m."), Range(0.0f, 1e+06f)] public float maxSamplingMetres;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static PcssAngularParameters Default => new PcssAngularParameters
            { blockerSamples = 1, filterSamples = 1, blockerClump = 0.0f, minFilterTexels = 1.25f,
              maxPenumbraMetres = 100.0f, maxSamplingMetres = 1000.0f };

        /// <summary>_PenumbraPcssAngularParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(blockerSamples, 1, 64),
            Bounded.Count(filterSamples, 1, 64), Bounded.OrLow(blockerClump, 0.0f, 8.0f),
            Bounded.OrLow(minFilterTexels, 0.0f, 64.0f));
        /// <summary>_PenumbraPcssAngularParameters1, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(maxPenumbraMetres, 0.0f, 1e+06f),
            Bounded.OrLow(maxSamplingMetres, 0.0f, 1e+06f), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }
}
