using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// What the resolve pass computes, one entry for each shader keyword of ShaderLibrary/Shadows.hlsl. Inspectors, pages
    /// and reports call a technique by its name here.
    /// </summary>
    public enum ShadowTechnique
    {
        /// <summary>Tent filter of 3 x 3 texels, 4 fetches. No contact hardening.</summary>
        [InspectorName("Tent 3x3")]
        Tent3x3,

        /// <summary>Tent filter of 5 x 5 texels, 9 fetches. No contact hardening.</summary>
        [InspectorName("Tent 5x5")]
        Tent5x5,

        /// <summary>Tent filter of 7 x 7 texels, 16 fetches. No contact hardening.</summary>
        [InspectorName("Tent 7x7")]
        Tent7x7,

        /// <summary>Percentage-closer soft shadows of a disc, with Fibonacci disks: blocker and filter samples are counted apart.</summary>
        [InspectorName("PCSS")]
        Pcss,

        /// <summary>PCSS with Poisson disks (Fernando 2005): one sample count, 25 to 128.</summary>
        [InspectorName("PCSS (Poisson)")]
        PcssPoisson,

        /// <summary>PCSS with the rules and parameters of Unity's HDRP, for a look that matches it.</summary>
        [InspectorName("PCSS (HDRP)")]
        PcssHdrp,
    }

    /// <summary>Shader keywords of the techniques; Tent5x5 is what the shader does without any.</summary>
    internal static class TechniqueKeywords
    {
        /// <summary>By technique; null where there is none.</summary>
        internal static readonly string[] Names =
        {
            "_PENUMBRA_TENT_3X3", null, "_PENUMBRA_TENT_7X7", "_PENUMBRA_PCSS", "_PENUMBRA_PCSS_POISSON",
            "_PENUMBRA_PCSS_HDRP",
        };

        internal static bool TakesSamples(this ShadowTechnique technique) => technique >= ShadowTechnique.Pcss;
    }
}
