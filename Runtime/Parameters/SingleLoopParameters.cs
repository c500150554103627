using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/SingleLoop/SingleLoop.technique.json; do not edit.
    /// <summary>Soft shadows of one loop over the rings of a disc.</summary>
    [System.Serializable]
    public struct SingleLoopParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraSingleLoopParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraSingleLoopParameters1");

        /// <summary>Taps, one on each ring of the disc, 1 to 32. Unit: fetches.</summary>
        [Tooltip("Taps, one on each ring of the disc, 1 to 32. Unit: fetches."), Range(1, 32)] public int samples;
        /// <summary>Rings of the disc: 1 of equal area, 2 of equal width.</summary>
        [Tooltip("Rings of the disc: 1 of equal area, 2 of equal width."), Range(1, 2)] public int ringExponent;
        /// <summary>Largest radius of the disc, and with it of a penumbra, across the light. Unit: m.</summary>
        [Tooltip("Largest radius of the disc, and with it of a penumbra, across the light. Unit: m."), Range(0.0f, 1e+06f)] public float discRadiusMetres;
        /// <summary>Smallest radius of disc and penumbra. Unit: texels.</summary>
        [Tooltip("Smallest radius of disc and penumbra. Unit: texels."), Range(0.0f, 64.0f)] public float minFilterTexels;
        /// <summary>Of the map of nearest and farthest depths that an early exit reads: its radius in cascade 0. Unit: texels.</summary>
        [Tooltip("Of the map of nearest and farthest depths that an early exit reads: its radius in cascade 0. Unit: texels."), Range(0, 16)] public int dilation0;
        /// <summary>The same in cascade 1. Unit: texels.</summary>
        [Tooltip("The same in cascade 1. Unit: texels."), Range(0, 16)] public int dilation1;
        /// <summary>The same in cascade 2. Unit: texels.</summary>
        [Tooltip("The same in cascade 2. Unit: texels."), Range(0, 16)] public int dilation2;
        /// <summary>The same in cascade 3. Unit: texels.</summary>
        [Tooltip("The same in cascade 3. Unit: texels."), Range(0, 16)] public int dilation3;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static SingleLoopParameters Default => new SingleLoopParameters
            { samples = 32, ringExponent = 1, discRadiusMetres = 0.05f, minFilterTexels = 1.25f, dilation0 = 8,
              dilation1 = 4, dilation2 = 3, dilation3 = 0 };

        /// <summary>_PenumbraSingleLoopParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(samples, 1, 32), Bounded.Count(ringExponent, 1, 2),
            Bounded.OrLow(discRadiusMetres, 0.0f, 1e+06f), Bounded.OrLow(minFilterTexels, 0.0f, 64.0f));
        /// <summary>_PenumbraSingleLoopParameters1, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector1 => new Vector4(Bounded.Count(dilation0, 0, 16), Bounded.Count(dilation1, 0, 16),
            Bounded.Count(dilation2, 0, 16), Bounded.Count(dilation3, 0, 16));

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }
}
