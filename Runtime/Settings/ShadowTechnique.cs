using UnityEngine;

namespace Penumbra
{
    // Written by `penumbra emit` from the manifests, *.technique.json; do not edit.
    /// <summary>
    /// The technique that computes the visibility: one entry for each shader keyword of ShaderLibrary/Shadows.hlsl that
    /// the feature offers, and for each that passes of its own draw. Inspectors, documentation and reports use these
    /// names.
    /// </summary>
    public enum ShadowTechnique
    {
        /// <summary>Tent filter of 3 x 3 texels, 4 fetches. No contact hardening.</summary>
        [InspectorName("Tent 3x3")] Tent3x3 = 0,

        /// <summary>Tent filter of 5 x 5 texels, 9 fetches. No contact hardening.</summary>
        [InspectorName("Tent 5x5")] Tent5x5 = 1,

        /// <summary>Tent filter of 7 x 7 texels, 16 fetches. No contact hardening.</summary>
        [InspectorName("Tent 7x7")] Tent7x7 = 2,

        /// <summary>Percentage-closer soft shadows of a disc, with Fibonacci disks and separate numbers of blocker and filter samples.</summary>
        [InspectorName("PCSS")] Pcss = 3,

        /// <summary>PCSS with Poisson disks (Fernando 2005): one number of samples for search and filter: 25, 32 or 64.</summary>
        [InspectorName("PCSS (Poisson)")] PcssPoisson = 4,

        /// <summary>PCSS with the rules and parameters of Unity's HDRP, to match its appearance.</summary>
        [InspectorName("PCSS (HDRP)")] PcssHdrp = 5,

        /// <summary>Variance shadow map: the shadow map blurred beforehand, one fetch for a filter of any width. Light leaks in where casters overlap.</summary>
        [InspectorName("VSM")] Vsm = 6,

        /// <summary>Exponential shadow map: the shadow map blurred beforehand, one fetch. Does not leak where casters overlap; shadows fade at contacts.</summary>
        [InspectorName("ESM")] Esm = 7,

        /// <summary>Exponential shadow map in logarithmic space, of 16 bits: fades less at contacts than ESM of 16 bits.</summary>
        [InspectorName("ESM, log space")] EsmLog = 8,

        /// <summary>Exponential variance shadow map: the shadow map blurred beforehand, one fetch. Leaks less than VSM, for twice the memory.</summary>
        [InspectorName("EVSM")] Evsm = 9,

        /// <summary>Moment shadow map: four moments of the shadow map, blurred beforehand, one fetch. Of the maps that are filtered once it has the least error in penumbrae.</summary>
        [InspectorName("MSM")] Msm = 10,

        /// <summary>Search and filter are the same fetches, up to 32: every pixel costs the same.</summary>
        [InspectorName("Single loop")] SingleLoop = 11,

        /// <summary>Single loop that is left early by a map of nearest and farthest depths around each texel. Penumbrae end where the map does not reach.</summary>
        [InspectorName("Single loop, min-max exits")] SingleLoopMinMax = 12,

        /// <summary>Single loop that is left early by mip levels of nearest and farthest depths, with the same picture.</summary>
        [InspectorName("Single loop, mip exits")] SingleLoopMips = 13,

        /// <summary>Single loop that is left early by mip levels of planes around the depths, on slopes too, with the same picture.</summary>
        [InspectorName("Single loop, plane exits")] SingleLoopPlanes = 14,

        /// <summary>Variance soft shadow map over a summed-area table, made by a compute shader: wide penumbrae without grain. Light leaks in where casters overlap.</summary>
        [InspectorName("VSSM, SAT")] Vssm = 15,

        /// <summary>Variance soft shadow map over mip levels: cheaper than with a summed-area table, and coarser.</summary>
        [InspectorName("VSSM, mips")] VssmMips = 16,

        /// <summary>Moment soft shadow map over a summed-area table, made by a compute shader: wide penumbrae without grain. Under wide lights less error than VSSM, and more light leaks.</summary>
        [InspectorName("MSSM, SAT")] Mssm = 17,

        /// <summary>Moment soft shadow map over mip levels of 16 bits: cheaper than with a summed-area table, and coarser.</summary>
        [InspectorName("MSSM, mips")] MssmMips = 18,

        /// <summary>Exponential variance map with mip levels and a search for blockers, with the rules and parameters of Filament.</summary>
        [InspectorName("EVSM, mip search (Filament)")] EvsmMips = 19,

        /// <summary>Rays through the shadow map to points of the light, with the rules and parameters of Unreal Engine.</summary>
        [InspectorName("SMRT (Unreal)")] Smrt = 20,

        /// <summary>PCSS with the rules and parameters of Godot 4.</summary>
        [InspectorName("PCSS (Godot)")] PcssGodot = 21,

        /// <summary>One set of samples, up to 16, for search and filter, with the rules and parameters of Filament.</summary>
        [InspectorName("DPCF (Filament)")] DpcfFilament = 22,

        /// <summary>PCSS with the rules and parameters of Filament: up to 16 samples of either kind.</summary>
        [InspectorName("PCSS (Filament)")] PcssFilament = 23,

        /// <summary>PCSS by compute shaders: tiles of the screen that are lit or dark are not filtered, the others are smoothed by the width of their penumbrae. Where a device cannot run it: Bounded PCSS.</summary>
        [InspectorName("Tiled PCSS")] TiledPcss = 24,

        /// <summary>Tiled PCSS's filter in each pixel, without compute shaders: a search that ends where no blocker can be, two layers where shadows overlap. Transparent and other forward shaders can have it, too.</summary>
        [InspectorName("Bounded PCSS")] PcssBounded = 25,
    }
}
