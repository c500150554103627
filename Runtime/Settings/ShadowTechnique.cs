using System;
using UnityEngine;

namespace Penumbra
{
    // Written by `penumbra validate --emit-selections` from the manifests, *.technique.json; do not edit.
    /// <summary>
    /// The technique of the resolve pass: one entry for each shader keyword of ShaderLibrary/Shadows.hlsl that the
    /// feature offers. Inspectors, documentation and reports use these names.
    /// </summary>
    public enum ShadowTechnique
    {
        /// <summary>Tent filter of 3 x 3 texels, 4 fetches. No contact hardening.</summary>
        [InspectorName("Tent 3x3")]
        Tent3x3 = 0,

        /// <summary>Tent filter of 5 x 5 texels, 9 fetches. No contact hardening.</summary>
        [InspectorName("Tent 5x5")]
        Tent5x5 = 1,

        /// <summary>Tent filter of 7 x 7 texels, 16 fetches. No contact hardening.</summary>
        [InspectorName("Tent 7x7")]
        Tent7x7 = 2,

        /// <summary>Percentage-closer soft shadows of a disc, with Fibonacci disks and separate numbers of blocker and filter samples.</summary>
        [InspectorName("PCSS")]
        Pcss = 3,

        /// <summary>PCSS with Poisson disks (Fernando 2005): one sample count, 25 to 128.</summary>
        [InspectorName("PCSS (Poisson)")]
        PcssPoisson = 4,

        /// <summary>PCSS with the rules and parameters of Unity's HDRP, to match its appearance.</summary>
        [InspectorName("PCSS (HDRP)")]
        PcssHdrp = 5,
    }

    /// <summary>Properties of each technique, indexed by ShadowTechnique.</summary>
    internal static class TechniqueTable
    {
        /// <summary>Shader keywords; null for the technique that is used without one.</summary>
        internal static readonly string[] Keywords =
        {
            "_PENUMBRA_TENT_3X3",
            null,
            "_PENUMBRA_TENT_7X7",
            "_PENUMBRA_PCSS",
            "_PENUMBRA_PCSS_POISSON",
            "_PENUMBRA_PCSS_HDRP",
        };

        private static readonly bool[] Sampled = { false, false, false, true, true, true };

        private static readonly string[][] Options =
        {
            new string[0],
            new string[0],
            new string[0],
            new[]
            {
                nameof(ShadowOptions.blockerSamples),
                nameof(ShadowOptions.filterSamples),
                nameof(ShadowOptions.minFilterTexels),
                nameof(ShadowOptions.softnessCapMetres),
            },
            new[]
            {
                nameof(ShadowOptions.blockerSamples),
                nameof(ShadowOptions.minFilterTexels),
            },
            new[]
            {
                nameof(ShadowOptions.blockerSamples),
                nameof(ShadowOptions.filterSamples),
            },
        };

        /// <summary>Parameters that the technique's rules change from a cascade on; empty without rules.</summary>
        internal static readonly CascadeVector[][] Cascades =
        {
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
        };

        /// <summary>The technique samples the light's disc: penumbrae widen with the disc, and are noisy.</summary>
        internal static bool TakesSamples(this ShadowTechnique technique) => Sampled[(int)technique];

        /// <summary>Whether this field of ShadowOptions sets a parameter of the technique's filter.</summary>
        internal static bool Takes(this ShadowTechnique technique, string option) =>
            Array.IndexOf(Options[(int)technique], option) >= 0;
    }
}
