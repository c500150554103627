using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Peers/FilamentPcss.technique.json; do not edit.
    /// <summary>PCSS and DPCF (Filament): with the rules and parameters of Filament.</summary>
    [System.Serializable]
    public struct FilamentParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraFilamentParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraFilamentParameters1");

        /// <summary>Samples of the blocker search, 1 to 16. Unit: fetches.</summary>
        [Tooltip("Samples of the blocker search, 1 to 16. Unit: fetches."), Range(1, 16)] public int blockerSamples;
        /// <summary>Samples of the filter of PCSS, 1 to 16. Unit: fetches.</summary>
        [Tooltip("Samples of the filter of PCSS, 1 to 16. Unit: fetches."), Range(1, 16)] public int filterSamples;
        /// <summary>Radius of the bulb at the near plane, to which discShare adds. Unit: m.</summary>
        [Tooltip("Radius of the bulb at the near plane, to which discShare adds. Unit: m."), Range(0.0f, 1e+06f)] public float bulbRadiusMetres;
        /// <summary>Radius of the bulb, as a share of that of the light's disc at the distance of the whole depth range.</summary>
        [Tooltip("Radius of the bulb, as a share of that of the light's disc at the distance of the whole depth range."), Range(0.0f, 64.0f)] public float discShare;
        /// <summary>By which the receiver moves along its normal, times the sine of its angle to the light. Unit: half texels.</summary>
        [Tooltip("By which the receiver moves along its normal, times the sine of its angle to the light. Unit: half texels."), Range(0.0f, 64.0f)] public float normalBias;
        /// <summary>By whose change of depth on its plane the receiver moves toward the light; 0 where casters are drawn with a slope-scaled bias. Unit: texels.</summary>
        [Tooltip("By whose change of depth on its plane the receiver moves toward the light; 0 where casters are drawn with a slope-scaled bias. Unit: texels."), Range(0.0f, 64.0f)] public float slopeBias;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static FilamentParameters Default => new FilamentParameters
            { blockerSamples = 16, filterSamples = 16, bulbRadiusMetres = 0.0f, discShare = 0.5f,
              normalBias = 1.0f, slopeBias = 0.0f };

        /// <summary>_PenumbraFilamentParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(blockerSamples, 1, 16),
            Bounded.Count(filterSamples, 1, 16), Bounded.OrLow(bulbRadiusMetres, 0.0f, 1e+06f),
            Bounded.OrLow(discShare, 0.0f, 64.0f));
        /// <summary>_PenumbraFilamentParameters1, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(normalBias, 0.0f, 64.0f),
            Bounded.OrLow(slopeBias, 0.0f, 64.0f), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }
}
