using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Mssm.technique.json; do not edit.
    /// <summary>Moment soft shadow mapping.</summary>
    [System.Serializable]
    public struct MssmParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMssmParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraMssmParameters1");

        /// <summary>Smallest filter and search radius. Unit: texels.</summary>
        [Tooltip("Smallest filter and search radius. Unit: texels."), Range(0.5f, 64.0f)] public float minFilterTexels;
        /// <summary>Largest penumbra width, from visibility 0 to 1; caps both radii. Unit: m.</summary>
        [Tooltip("Largest penumbra width, from visibility 0 to 1; caps both radii. Unit: m."), Range(0.0f, 1e+06f)] public float maxPenumbraMetres;
        /// <summary>Visibility up to which all is dark, which reduces light bleeding.</summary>
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;
        /// <summary>Share of a smooth distribution in the moments, against their rounding.</summary>
        [Tooltip("Share of a smooth distribution in the moments, against their rounding."), Range(1e-07f, 0.1f)] public float mix;
        /// <summary>Searches for blockers, each within the penumbra that the one before found; the paper has one.</summary>
        [Tooltip("Searches for blockers, each within the penumbra that the one before found; the paper has one."), Range(1, 4)] public int searches;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static MssmParameters Default => new MssmParameters
            { minFilterTexels = 1.0f, maxPenumbraMetres = 100.0f, bleeding = 0.2f, mix = 6e-05f, searches = 3 };

        /// <summary>_PenumbraMssmParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(minFilterTexels, 0.5f, 64.0f),
            Bounded.OrLow(maxPenumbraMetres, 0.0f, 1e+06f), Bounded.OrLow(bleeding, 0.0f, 0.95f),
            Bounded.OrLow(mix, 1e-07f, 0.1f));
        /// <summary>_PenumbraMssmParameters1, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector1 => new Vector4(Bounded.Count(searches, 1, 4), 0.0f, 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }
}
