using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Pcss/PcssClassic.technique.json; do not edit.
    /// <summary>PCSS (Poisson): as many blocker samples as filter samples, on Poisson disks.</summary>
    [System.Serializable]
    public struct PcssClassicParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPcssClassicParameters0");

        /// <summary>Number of blocker samples and of filter samples: 25, 32, 64, 100 or 128. Unit: fetches.</summary>
        [Tooltip("Number of blocker samples and of filter samples: 25, 32, 64, 100 or 128. Unit: fetches."), Range(25, 128)] public int samples;
        /// <summary>Radius of the blocker search, across the light. Unit: m.</summary>
        [Tooltip("Radius of the blocker search, across the light. Unit: m."), Range(0.0f, 1e+06f)] public float searchRadiusMetres;
        /// <summary>Smallest filter radius. Unit: texels.</summary>
        [Tooltip("Smallest filter radius. Unit: texels."), Range(0.0f, 64.0f)] public float minFilterTexels;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static PcssClassicParameters Default => new PcssClassicParameters
            { samples = 25, searchRadiusMetres = 0.5f, minFilterTexels = 1.25f };

        /// <summary>_PenumbraPcssClassicParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(samples, 25, 128),
            Bounded.OrLow(searchRadiusMetres, 0.0f, 1e+06f), Bounded.OrLow(minFilterTexels, 0.0f, 64.0f), 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
