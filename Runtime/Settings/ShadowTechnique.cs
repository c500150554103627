using System;
using UnityEngine;
using UnityEngine.Rendering;

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

        /// <summary>PCSS with Poisson disks (Fernando 2005): one number of samples for search and filter: 25, 32 or 64.</summary>
        [InspectorName("PCSS (Poisson)")]
        PcssPoisson = 4,

        /// <summary>PCSS with the rules and parameters of Unity's HDRP, to match its appearance.</summary>
        [InspectorName("PCSS (HDRP)")]
        PcssHdrp = 5,

        /// <summary>Variance shadow map: the shadow map blurred beforehand, one fetch for a filter of any width. Light leaks in where casters overlap.</summary>
        [InspectorName("VSM")]
        Vsm = 6,

        /// <summary>Exponential shadow map: the shadow map blurred beforehand, one fetch. Does not leak where casters overlap; shadows fade at contacts.</summary>
        [InspectorName("ESM")]
        Esm = 7,

        /// <summary>Exponential shadow map in logarithmic space, of 16 bits: fades less at contacts than ESM of 16 bits.</summary>
        [InspectorName("ESM, log space")]
        EsmLog = 8,

        /// <summary>Exponential variance shadow map: the shadow map blurred beforehand, one fetch. Leaks less than VSM, for twice the memory.</summary>
        [InspectorName("EVSM")]
        Evsm = 9,

        /// <summary>Moment shadow map: four moments of the shadow map, blurred beforehand, one fetch. Of the maps that are filtered once it has the least error in penumbrae.</summary>
        [InspectorName("MSM")]
        Msm = 10,

        /// <summary>Search and filter are the same fetches, up to 32: every pixel costs the same.</summary>
        [InspectorName("Single loop")]
        SingleLoop = 11,

        /// <summary>Single loop that is left early by a map of nearest and farthest depths around each texel. Penumbrae end where the map does not reach.</summary>
        [InspectorName("Single loop, min-max exits")]
        SingleLoopMinMax = 12,

        /// <summary>Single loop that is left early by mip levels of nearest and farthest depths, with the same picture.</summary>
        [InspectorName("Single loop, mip exits")]
        SingleLoopMips = 13,

        /// <summary>Single loop that is left early by mip levels of planes around the depths, on slopes too, with the same picture.</summary>
        [InspectorName("Single loop, plane exits")]
        SingleLoopPlanes = 14,

        /// <summary>Variance soft shadow map over a summed-area table, made by a compute shader: wide penumbrae without grain. Light leaks in where casters overlap.</summary>
        [InspectorName("VSSM, SAT")]
        Vssm = 15,

        /// <summary>Variance soft shadow map over mip levels: cheaper than with a summed-area table, and coarser.</summary>
        [InspectorName("VSSM, mips")]
        VssmMips = 16,

        /// <summary>Moment soft shadow map over a summed-area table, made by a compute shader: wide penumbrae without grain. Under wide lights less error than VSSM, and more light leaks.</summary>
        [InspectorName("MSSM, SAT")]
        Mssm = 17,

        /// <summary>Moment soft shadow map over mip levels of 16 bits: cheaper than with a summed-area table, and coarser.</summary>
        [InspectorName("MSSM, mips")]
        MssmMips = 18,

        /// <summary>Exponential variance map with mip levels and a search for blockers, with the rules and parameters of Filament.</summary>
        [InspectorName("EVSM, mip search (Filament)")]
        EvsmMips = 19,

        /// <summary>Rays through the shadow map to points of the light, with the rules and parameters of Unreal Engine.</summary>
        [InspectorName("SMRT (Unreal)")]
        Smrt = 20,

        /// <summary>PCSS with the rules and parameters of Godot 4.</summary>
        [InspectorName("PCSS (Godot)")]
        PcssGodot = 21,

        /// <summary>One set of samples, up to 16, for search and filter, with the rules and parameters of Filament.</summary>
        [InspectorName("DPCF (Filament)")]
        DpcfFilament = 22,

        /// <summary>PCSS with the rules and parameters of Filament: up to 16 samples of either kind.</summary>
        [InspectorName("PCSS (Filament)")]
        PcssFilament = 23,

        /// <summary>Penumbrae of a disc from all texels of the shadow map around a pixel, without noise, by compute shaders. Where a device cannot run them: PCSS.</summary>
        [InspectorName("Flagship")]
        Flagship = 24,

        /// <summary>The flagship's penumbrae, from its filter in each pixel: without compute shaders, for more fetches. Transparent and other forward shaders can have the same filter.</summary>
        [InspectorName("Flagship, per pixel")]
        FlagshipPixel = 25,
    }

    /// <summary>Sets the parameters of a technique's passes and filter. Does not allocate.</summary>
    internal delegate void SetParameters(CommandBuffer commands, in ShadowOptions options);

    /// <summary>Sets some of the options.</summary>
    internal delegate void SetOptions(ref ShadowOptions options);

    /// <summary>Properties of each technique, indexed by ShadowTechnique.</summary>
    internal static class TechniqueTable
    {
        /// <summary>
        /// Shader keywords; null for the technique that is used without one. Passes that draw the visibility have their
        /// fallback's.
        /// </summary>
        internal static readonly string[] Keywords =
        {
            "_PENUMBRA_TENT_3X3",
            null,
            "_PENUMBRA_TENT_7X7",
            "_PENUMBRA_PCSS",
            "_PENUMBRA_PCSS_POISSON",
            "_PENUMBRA_PCSS_HDRP",
            "_PENUMBRA_VSM",
            "_PENUMBRA_ESM",
            "_PENUMBRA_ESM_LOG",
            "_PENUMBRA_EVSM",
            "_PENUMBRA_MSM",
            "_PENUMBRA_SINGLE_LOOP",
            "_PENUMBRA_SINGLE_LOOP_MIN_MAX",
            "_PENUMBRA_SINGLE_LOOP_MIPS",
            "_PENUMBRA_SINGLE_LOOP_PLANES",
            "_PENUMBRA_VSSM",
            "_PENUMBRA_VSSM_MIPS",
            "_PENUMBRA_MSSM",
            "_PENUMBRA_MSSM_MIPS",
            "_PENUMBRA_EVSM_MIPS",
            "_PENUMBRA_SMRT",
            "_PENUMBRA_PCSS_GODOT",
            "_PENUMBRA_DPCF_FILAMENT",
            "_PENUMBRA_PCSS_FILAMENT",
            "_PENUMBRA_PCSS",
            "_PENUMBRA_FLAGSHIP_PIXEL",
        };

        private static readonly bool[] Sampled =
        {
            false, false, false, true, true, true, false, false, false, false,
            false, true, true, true, true, false, false, false, false, false,
            true, true, true, true, false, false,
        };

        private static readonly bool[] Widens =
        {
            false, false, false, true, true, true, false, false, false, false,
            false, true, true, true, true, true, true, true, true, true,
            true, true, true, true, true, true,
        };

        private static readonly bool[] Target45 =
        {
            false, false, false, true, true, true, false, false, true, false,
            false, true, true, true, true, false, true, false, true, true,
            true, true, true, true, true, true,
        };

        private static readonly bool[] Limiting =
        {
            false, false, false, true, false, true, false, false, false, false,
            false, false, false, false, false, true, true, true, true, false,
            false, false, false, false, true, true,
        };

        private static readonly bool[] Biased =
        {
            false, false, false, false, false, false, false, false, false, false,
            false, false, false, false, false, false, false, false, false, false,
            true, true, true, true, false, false,
        };

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
            new[]
            {
                nameof(ShadowOptions.lightBleeding),
                nameof(ShadowOptions.mapBlurTexels),
            },
            new[]
            {
                nameof(ShadowOptions.lightBleeding),
                nameof(ShadowOptions.mapBlurTexels),
            },
            new[]
            {
                nameof(ShadowOptions.lightBleeding),
                nameof(ShadowOptions.mapBlurTexels),
            },
            new[]
            {
                nameof(ShadowOptions.lightBleeding),
                nameof(ShadowOptions.mapBlurTexels),
            },
            new[]
            {
                nameof(ShadowOptions.lightBleeding),
                nameof(ShadowOptions.mapBlurTexels),
            },
            new[]
            {
                nameof(ShadowOptions.blockerSamples),
                nameof(ShadowOptions.discRadiusMetres),
                nameof(ShadowOptions.minFilterTexels),
            },
            new[]
            {
                nameof(ShadowOptions.blockerSamples),
                nameof(ShadowOptions.discRadiusMetres),
                nameof(ShadowOptions.minFilterTexels),
            },
            new[]
            {
                nameof(ShadowOptions.blockerSamples),
                nameof(ShadowOptions.discRadiusMetres),
                nameof(ShadowOptions.minFilterTexels),
            },
            new[]
            {
                nameof(ShadowOptions.blockerSamples),
                nameof(ShadowOptions.discRadiusMetres),
                nameof(ShadowOptions.minFilterTexels),
            },
            new[]
            {
                nameof(ShadowOptions.lightBleeding),
                nameof(ShadowOptions.minFilterTexels),
                nameof(ShadowOptions.softnessCapMetres),
            },
            new[]
            {
                nameof(ShadowOptions.lightBleeding),
                nameof(ShadowOptions.minFilterTexels),
                nameof(ShadowOptions.softnessCapMetres),
            },
            new[]
            {
                nameof(ShadowOptions.lightBleeding),
                nameof(ShadowOptions.minFilterTexels),
                nameof(ShadowOptions.softnessCapMetres),
            },
            new[]
            {
                nameof(ShadowOptions.lightBleeding),
                nameof(ShadowOptions.minFilterTexels),
                nameof(ShadowOptions.softnessCapMetres),
            },
            new string[0],
            new[]
            {
                nameof(ShadowOptions.rays),
                nameof(ShadowOptions.samplesPerRay),
            },
            new[]
            {
                nameof(ShadowOptions.blockerSamples),
            },
            new[]
            {
                nameof(ShadowOptions.blockerSamples),
            },
            new[]
            {
                nameof(ShadowOptions.blockerSamples),
                nameof(ShadowOptions.filterSamples),
            },
            new[]
            {
                nameof(ShadowOptions.filterCells),
                nameof(ShadowOptions.softnessCapMetres),
            },
            new[]
            {
                nameof(ShadowOptions.softnessCapMetres),
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
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
            new CascadeVector[0],
        };

        /// <summary>
        /// The passes before the filter, which make the maps that it reads, or those that draw the visibility without
        /// one; empty for a filter of the shadow map alone.
        /// Of two the second makes maps of 16 bits: index with ShadowOptions.GraphIndex.
        /// </summary>
        internal static readonly TechniqueGraph[][] Graphs =
        {
            new TechniqueGraph[0],
            new TechniqueGraph[0],
            new TechniqueGraph[0],
            new TechniqueGraph[0],
            new TechniqueGraph[0],
            new TechniqueGraph[0],
            new[] { VarianceGraphs.Variance32, VarianceGraphs.Variance16 },
            new[] { ExponentialGraphs.Exponential32, ExponentialGraphs.Exponential16 },
            new[] { LogExponentialGraphs.LogExponential16 },
            new[] { ExponentialVarianceGraphs.ExponentialVariance32, ExponentialVarianceGraphs.ExponentialVariance16 },
            new[] { MomentShadowsGraphs.Moments32, MomentShadowsGraphs.Moments16 },
            new TechniqueGraph[0],
            new[] { SingleLoopGraphs.SingleLoopMinmax },
            new[] { SingleLoopGraphs.SingleLoopMips },
            new[] { SingleLoopGraphs.SingleLoopPlanes },
            new[] { VssmGraphs.VssmSat32 },
            new[] { VssmGraphs.VssmMip32, VssmGraphs.VssmMip16 },
            new[] { MssmGraphs.MssmSat32 },
            new[] { MssmGraphs.MssmMip16 },
            new[] { ExponentialLevelsGraphs.EvsmMip },
            new TechniqueGraph[0],
            new TechniqueGraph[0],
            new TechniqueGraph[0],
            new TechniqueGraph[0],
            new[] { PenumbraFlagshipGraphs.Flagship },
            new[] { DepthRingsGraphs.DepthRings },
        };

        /// <summary>Passes that draw the visibility at half resolution, in place of those of Graphs; null: none.</summary>
        internal static readonly TechniqueGraph[] HalfGraphs =
        {
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            PenumbraFlagshipGraphs.FlagshipHalf,
            null,
        };

        /// <summary>
        /// As Graphs, but one for a filter of the shadow map alone; empty where there are no parameters, or
        /// ShadowUniforms computes them.
        /// </summary>
        internal static readonly SetParameters[][] Parameters =
        {
            new SetParameters[0],
            new SetParameters[0],
            new SetParameters[0],
            new SetParameters[0],
            new SetParameters[0],
            new SetParameters[0],
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MapBlurParameters
                    {
                        deviation = options.mapBlurTexels,
                    }.SetGlobal(commands);
                    new VarianceParameters
                    {
                        bleeding = options.lightBleeding,
                        precision = 5.9604645e-08f,
                    }.SetGlobal(commands);
                },
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MapBlurParameters
                    {
                        deviation = options.mapBlurTexels,
                    }.SetGlobal(commands);
                    new VarianceParameters
                    {
                        bleeding = options.lightBleeding,
                        precision = 0.00048828125f,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MapBlurParameters
                    {
                        deviation = options.mapBlurTexels,
                    }.SetGlobal(commands);
                    new ExponentialParameters
                    {
                        exponent = 172.0f,
                        bleeding = options.lightBleeding,
                    }.SetGlobal(commands);
                },
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MapBlurParameters
                    {
                        deviation = options.mapBlurTexels,
                    }.SetGlobal(commands);
                    new ExponentialParameters
                    {
                        exponent = 19.0f,
                        bleeding = options.lightBleeding,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MapBlurParameters
                    {
                        deviation = options.mapBlurTexels,
                    }.SetGlobal(commands);
                    new LogExponentialParameters
                    {
                        exponent = 172.0f,
                        bleeding = options.lightBleeding,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MapBlurParameters
                    {
                        deviation = options.mapBlurTexels,
                    }.SetGlobal(commands);
                    new ExponentialVarianceParameters
                    {
                        positiveExponent = 80.0f,
                        negativeExponent = 10.0f,
                        bleeding = options.lightBleeding,
                        precision = 5.9604645e-08f,
                    }.SetGlobal(commands);
                },
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MapBlurParameters
                    {
                        deviation = options.mapBlurTexels,
                    }.SetGlobal(commands);
                    new ExponentialVarianceParameters
                    {
                        positiveExponent = 9.0f,
                        negativeExponent = 9.0f,
                        bleeding = options.lightBleeding,
                        precision = 0.00048828125f,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MapBlurParameters
                    {
                        deviation = options.mapBlurTexels,
                    }.SetGlobal(commands);
                    new MomentShadowsParameters
                    {
                        mix = 3e-07f,
                        bleeding = options.lightBleeding,
                    }.SetGlobal(commands);
                },
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MapBlurParameters
                    {
                        deviation = options.mapBlurTexels,
                    }.SetGlobal(commands);
                    new MomentShadowsParameters
                    {
                        mix = 6e-05f,
                        bleeding = options.lightBleeding,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new SingleLoopParameters
                    {
                        samples = options.blockerSamples,
                        ringExponent = 1,
                        discRadiusMetres = options.discRadiusMetres,
                        minFilterTexels = options.minFilterTexels,
                        dilation0 = 8,
                        dilation1 = 4,
                        dilation2 = 3,
                        dilation3 = 0,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new DepthRangeParameters
                    {
                        dilation0 = 8,
                        dilation1 = 4,
                        dilation2 = 3,
                        dilation3 = 0,
                    }.SetGlobal(commands);
                    new SingleLoopParameters
                    {
                        samples = options.blockerSamples,
                        ringExponent = 1,
                        discRadiusMetres = options.discRadiusMetres,
                        minFilterTexels = options.minFilterTexels,
                        dilation0 = 8,
                        dilation1 = 4,
                        dilation2 = 3,
                        dilation3 = 0,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new SingleLoopParameters
                    {
                        samples = options.blockerSamples,
                        ringExponent = 1,
                        discRadiusMetres = options.discRadiusMetres,
                        minFilterTexels = options.minFilterTexels,
                        dilation0 = 8,
                        dilation1 = 4,
                        dilation2 = 3,
                        dilation3 = 0,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new SingleLoopParameters
                    {
                        samples = options.blockerSamples,
                        ringExponent = 1,
                        discRadiusMetres = options.discRadiusMetres,
                        minFilterTexels = options.minFilterTexels,
                        dilation0 = 8,
                        dilation1 = 4,
                        dilation2 = 3,
                        dilation3 = 0,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new VssmParameters
                    {
                        minFilterTexels = options.minFilterTexels,
                        maxPenumbraMetres = options.softnessCapMetres,
                        bleeding = options.lightBleeding,
                        smallestVariance = 1.2e-07f,
                        searches = 3,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new VssmParameters
                    {
                        minFilterTexels = options.minFilterTexels,
                        maxPenumbraMetres = options.softnessCapMetres,
                        bleeding = options.lightBleeding,
                        smallestVariance = 5e-07f,
                        searches = 3,
                    }.SetGlobal(commands);
                },
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new VssmParameters
                    {
                        minFilterTexels = options.minFilterTexels,
                        maxPenumbraMetres = options.softnessCapMetres,
                        bleeding = options.lightBleeding,
                        smallestVariance = 4e-05f,
                        searches = 3,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MssmParameters
                    {
                        minFilterTexels = options.minFilterTexels,
                        maxPenumbraMetres = options.softnessCapMetres,
                        bleeding = options.lightBleeding,
                        mix = 6e-05f,
                        searches = 3,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new MssmParameters
                    {
                        minFilterTexels = options.minFilterTexels,
                        maxPenumbraMetres = options.softnessCapMetres,
                        bleeding = options.lightBleeding,
                        mix = 6e-05f,
                        searches = 3,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new ExponentialVarianceParameters
                    {
                        positiveExponent = 11.08f,
                        negativeExponent = 11.08f,
                        bleeding = 0.15f,
                        precision = 0.000125f,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new UnrealSmrtParameters
                    {
                        rays = options.rays,
                        samplesPerRay = options.samplesPerRay,
                        rayLengthScale = 1.5f,
                        texelDither = 2.0f,
                        largestSlopeMetres = 0.05f,
                        normalBias = 0.5f,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new GodotPcssParameters
                    {
                        samples = options.blockerSamples,
                        diameterShare = 1.0f,
                        depthBias = 0.001f,
                        normalBias = 2.0f,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new FilamentParameters
                    {
                        blockerSamples = options.blockerSamples,
                        filterSamples = 16,
                        bulbRadiusMetres = 0.0f,
                        discShare = 0.5f,
                        normalBias = 1.0f,
                        slopeBias = 0.0f,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new FilamentParameters
                    {
                        blockerSamples = options.blockerSamples,
                        filterSamples = options.filterSamples,
                        bulbRadiusMetres = 0.0f,
                        discShare = 0.5f,
                        normalBias = 1.0f,
                        slopeBias = 0.0f,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[]
            {
                (CommandBuffer commands, in ShadowOptions options) =>
                {
                    new FlagshipParameters
                    {
                        filterCells = options.filterCells,
                    }.SetGlobal(commands);
                },
            },
            new SetParameters[0],
        };

        private static readonly SetOptions[] Measured =
        {
            (ref ShadowOptions options) => { },
            (ref ShadowOptions options) => { },
            (ref ShadowOptions options) => { },
            (ref ShadowOptions options) =>
            {
                options.blockerSamples = 24;
                options.filterSamples = 16;
                options.minFilterTexels = 1.25f;
                options.softnessCapMetres = 100.0f;
            },
            (ref ShadowOptions options) =>
            {
                options.blockerSamples = 25;
                options.minFilterTexels = 1.25f;
            },
            (ref ShadowOptions options) =>
            {
                options.blockerSamples = 24;
                options.filterSamples = 16;
            },
            (ref ShadowOptions options) =>
            {
                options.lightBleeding = 0.2f;
                options.mapBlurTexels = 1.5f;
            },
            (ref ShadowOptions options) =>
            {
                options.lightBleeding = 0.2f;
                options.mapBlurTexels = 1.5f;
            },
            (ref ShadowOptions options) =>
            {
                options.lightBleeding = 0.2f;
                options.mapBlurTexels = 1.5f;
            },
            (ref ShadowOptions options) =>
            {
                options.lightBleeding = 0.2f;
                options.mapBlurTexels = 1.5f;
            },
            (ref ShadowOptions options) =>
            {
                options.lightBleeding = 0.2f;
                options.mapBlurTexels = 1.5f;
            },
            (ref ShadowOptions options) =>
            {
                options.blockerSamples = 32;
                options.discRadiusMetres = 0.05f;
                options.minFilterTexels = 1.25f;
            },
            (ref ShadowOptions options) =>
            {
                options.blockerSamples = 32;
                options.discRadiusMetres = 0.05f;
                options.minFilterTexels = 1.25f;
            },
            (ref ShadowOptions options) =>
            {
                options.blockerSamples = 32;
                options.discRadiusMetres = 0.05f;
                options.minFilterTexels = 1.25f;
            },
            (ref ShadowOptions options) =>
            {
                options.blockerSamples = 32;
                options.discRadiusMetres = 0.05f;
                options.minFilterTexels = 1.25f;
            },
            (ref ShadowOptions options) =>
            {
                options.lightBleeding = 0.2f;
                options.minFilterTexels = 1.0f;
                options.softnessCapMetres = 100.0f;
            },
            (ref ShadowOptions options) =>
            {
                options.lightBleeding = 0.2f;
                options.minFilterTexels = 1.0f;
                options.softnessCapMetres = 100.0f;
            },
            (ref ShadowOptions options) =>
            {
                options.lightBleeding = 0.2f;
                options.minFilterTexels = 1.0f;
                options.softnessCapMetres = 100.0f;
            },
            (ref ShadowOptions options) =>
            {
                options.lightBleeding = 0.2f;
                options.minFilterTexels = 1.0f;
                options.softnessCapMetres = 100.0f;
            },
            (ref ShadowOptions options) => { },
            (ref ShadowOptions options) =>
            {
                options.rays = 7;
                options.samplesPerRay = 8;
            },
            (ref ShadowOptions options) =>
            {
                options.blockerSamples = 8;
            },
            (ref ShadowOptions options) =>
            {
                options.blockerSamples = 12;
            },
            (ref ShadowOptions options) =>
            {
                options.blockerSamples = 16;
                options.filterSamples = 16;
            },
            (ref ShadowOptions options) =>
            {
                options.filterCells = 5;
                options.softnessCapMetres = 100.0f;
            },
            (ref ShadowOptions options) =>
            {
                options.softnessCapMetres = 100.0f;
            },
        };

        /// <summary>What is drawn where the technique cannot run; itself if it runs everywhere.</summary>
        internal static readonly ShadowTechnique[] Fallbacks =
        {
            ShadowTechnique.Tent3x3,
            ShadowTechnique.Tent5x5,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Tent7x7,
            ShadowTechnique.Pcss,
            ShadowTechnique.Tent7x7,
        };

        /// <summary>The technique samples the light's disc, so that its penumbrae are noisy.</summary>
        internal static bool TakesSamples(this ShadowTechnique technique) => Sampled[(int)technique];

        /// <summary>Penumbrae are as wide as the light's disc makes them.</summary>
        internal static bool WidensWithDisc(this ShadowTechnique technique) => Widens[(int)technique];

        /// <summary>The filter gathers texels or searches for bits, which needs shader target 4.5.</summary>
        internal static bool NeedsTarget45(this ShadowTechnique technique) => Target45[(int)technique];

        /// <summary>The filter itself limits how wide penumbrae are, in metres.</summary>
        internal static bool LimitsWidth(this ShadowTechnique technique) => Limiting[(int)technique];

        /// <summary>The filter biases receivers itself: the light's own biases should be 0.</summary>
        internal static bool HasOwnBias(this ShadowTechnique technique) => Biased[(int)technique];

        /// <summary>Gives the technique's own options the values that it is measured with.</summary>
        internal static void SetMeasured(this ShadowTechnique technique, ref ShadowOptions options) =>
            Measured[(int)technique](ref options);

        /// <summary>Whether this field of ShadowOptions sets a parameter of the technique's passes or filter.</summary>
        internal static bool Takes(this ShadowTechnique technique, string option) =>
            Array.IndexOf(Options[(int)technique], option) >= 0;
    }
}
