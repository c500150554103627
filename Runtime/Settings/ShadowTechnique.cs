using System;
using UnityEngine;

namespace Penumbra
{
    // Written by `penumbra validate --emit-selections` from the manifests, *.technique.json; do not edit.
    /// <summary>
    /// What the resolve pass computes, one entry for each shader keyword of ShaderLibrary/Shadows.hlsl that the feature
    /// offers. Inspectors, pages and reports call a technique by its name here.
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

        /// <summary>Percentage-closer soft shadows of a disc, with Fibonacci disks: blocker and filter samples are counted apart.</summary>
        [InspectorName("PCSS")]
        Pcss = 3,

        /// <summary>PCSS with Poisson disks (Fernando 2005): one sample count, 25 to 128.</summary>
        [InspectorName("PCSS (Poisson)")]
        PcssPoisson = 4,

        /// <summary>PCSS with the rules and parameters of Unity's HDRP, for a look that matches it.</summary>
        [InspectorName("PCSS (HDRP)")]
        PcssHdrp = 5,
    }

    /// <summary>What the shader and the inspectors know of each technique, by its number.</summary>
    internal static class TechniqueTable
    {
        /// <summary>Shader keywords; null for what the shader does without any.</summary>
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

        /// <summary>What filters are told from a cascade on, by the technique's rules; empty without any.</summary>
        internal static readonly CascadeVector[][] Cascades =
        {
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
        };

        /// <summary>It samples the light's disc: penumbrae widen with the disc, and are grainy.</summary>
        internal static bool TakesSamples(this ShadowTechnique technique) => Sampled[(int)technique];

        /// <summary>A parameter of its filter is set by this field of ShadowOptions.</summary>
        internal static bool Takes(this ShadowTechnique technique, string option) =>
            Array.IndexOf(Options[(int)technique], option) >= 0;
    }
}
