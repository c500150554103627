using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraShadows.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class PenumbraShadowsGraphs
    {
        internal static readonly TechniqueGraph Tent = new TechniqueGraph
        {
            name = "tent",
            textures = new[]
            {
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    absent = new[] { "_PenumbraMaskTexture", "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(0) },
                },
            },
            visibility = 0,
        };

        internal static readonly TechniqueGraph TentMasked = new TechniqueGraph
        {
            name = "tent-masked",
            textures = new[]
            {
                new GraphTexture("found", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("wide", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("mask", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "PenumbraMask",
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "MaskBlurHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "MaskBlurVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraMaskTexture", 2) },
                    absent = new[] { "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(3) },
                },
            },
            visibility = 3,
            mask = 2,
        };

        internal static readonly TechniqueGraph Pcss = new TechniqueGraph
        {
            name = "pcss",
            textures = new[]
            {
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    absent = new[] { "_PenumbraMaskTexture", "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(0) },
                },
            },
            visibility = 0,
        };

        internal static readonly TechniqueGraph PcssMasked = new TechniqueGraph
        {
            name = "pcss-masked",
            textures = new[]
            {
                new GraphTexture("found", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("wide", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("mask", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "PenumbraMask",
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "MaskBlurHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "MaskBlurVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraMaskTexture", 2) },
                    absent = new[] { "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(3) },
                },
            },
            visibility = 3,
            mask = 2,
        };

        internal static readonly TechniqueGraph PcssConservative = new TechniqueGraph
        {
            name = "pcss-conservative",
            textures = new[]
            {
                new GraphTexture("depthPlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 4, mips: 0),
                new GraphTexture("mask", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "QuarterDepthPlanes",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "DepthPlanesMip",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(0) },
                    eachMip = true,
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "ConservativeMask",
                    reads = new[] { GraphBinding.Texture("_PenumbraDepthPlanesTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraMaskTexture", 1) },
                    absent = new[] { "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(2) },
                },
            },
            visibility = 2,
            mask = 1,
        };

        internal static readonly TechniqueGraph PcssDenoised = new TechniqueGraph
        {
            name = "pcss-denoised",
            textures = new[]
            {
                new GraphTexture("resolved", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("rows", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    absent = new[] { "_PenumbraMaskTexture", "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
            },
            visibility = 2,
        };

        internal static readonly TechniqueGraph PcssMaskedDenoised = new TechniqueGraph
        {
            name = "pcss-masked-denoised",
            textures = new[]
            {
                new GraphTexture("found", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("wide", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("mask", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("resolved", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("rows", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "PenumbraMask",
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "MaskBlurHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "MaskBlurVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraMaskTexture", 2) },
                    absent = new[] { "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(3) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 3) },
                    writes = new[] { GraphBinding.Texture(4) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 4) },
                    writes = new[] { GraphBinding.Texture(5) },
                },
            },
            visibility = 5,
            mask = 2,
        };

        internal static readonly TechniqueGraph PcssConservativeDenoised = new TechniqueGraph
        {
            name = "pcss-conservative-denoised",
            textures = new[]
            {
                new GraphTexture("depthPlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 4, mips: 0),
                new GraphTexture("mask", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("resolved", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("rows", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "QuarterDepthPlanes",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "DepthPlanesMip",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(0) },
                    eachMip = true,
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "ConservativeMask",
                    reads = new[] { GraphBinding.Texture("_PenumbraDepthPlanesTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraMaskTexture", 1) },
                    absent = new[] { "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 2) },
                    writes = new[] { GraphBinding.Texture(3) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 3) },
                    writes = new[] { GraphBinding.Texture(4) },
                },
            },
            visibility = 4,
            mask = 1,
        };

        internal static readonly TechniqueGraph PcssHalf = new TechniqueGraph
        {
            name = "pcss-half",
            textures = new[]
            {
                new GraphTexture("half", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 2),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    absent = new[] { "_PenumbraMaskTexture", "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    absent = new[] { "_PenumbraMaskTexture" },
                    writes = new[] { GraphBinding.Texture(1) },
                },
            },
            visibility = 1,
        };

        internal static readonly TechniqueGraph PcssHalfDenoised = new TechniqueGraph
        {
            name = "pcss-half-denoised",
            textures = new[]
            {
                new GraphTexture("resolved", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("rows", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("half", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 2),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    absent = new[] { "_PenumbraMaskTexture", "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(3) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 3) },
                    absent = new[] { "_PenumbraMaskTexture" },
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
            },
            visibility = 2,
        };

        internal static readonly TechniqueGraph PcssMaskedHalf = new TechniqueGraph
        {
            name = "pcss-masked-half",
            textures = new[]
            {
                new GraphTexture("found", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("wide", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("mask", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("half", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 2),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "PenumbraMask",
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "MaskBlurHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "MaskBlurVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraMaskTexture", 2) },
                    absent = new[] { "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(3) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 3) },
                    absent = new[] { "_PenumbraMaskTexture" },
                    writes = new[] { GraphBinding.Texture(4) },
                },
            },
            visibility = 4,
            mask = 2,
        };

        internal static readonly TechniqueGraph PcssConservativeHalf = new TechniqueGraph
        {
            name = "pcss-conservative-half",
            textures = new[]
            {
                new GraphTexture("depthPlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 4, mips: 0),
                new GraphTexture("mask", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("half", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 2),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "QuarterDepthPlanes",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "DepthPlanesMip",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(0) },
                    eachMip = true,
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "ConservativeMask",
                    reads = new[] { GraphBinding.Texture("_PenumbraDepthPlanesTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraMaskTexture", 1) },
                    absent = new[] { "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 2) },
                    absent = new[] { "_PenumbraMaskTexture" },
                    writes = new[] { GraphBinding.Texture(3) },
                },
            },
            visibility = 3,
            mask = 1,
        };

        internal static readonly TechniqueGraph PcssMaskedHalfDenoised = new TechniqueGraph
        {
            name = "pcss-masked-half-denoised",
            textures = new[]
            {
                new GraphTexture("found", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("wide", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("mask", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("resolved", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("rows", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("half", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 2),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "PenumbraMask",
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "MaskBlurHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "MaskBlurVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraMaskTexture", 2) },
                    absent = new[] { "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(6) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 6) },
                    absent = new[] { "_PenumbraMaskTexture" },
                    writes = new[] { GraphBinding.Texture(3) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 3) },
                    writes = new[] { GraphBinding.Texture(4) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 4) },
                    writes = new[] { GraphBinding.Texture(5) },
                },
            },
            visibility = 5,
            mask = 2,
        };

        internal static readonly TechniqueGraph PcssConservativeHalfDenoised = new TechniqueGraph
        {
            name = "pcss-conservative-half-denoised",
            textures = new[]
            {
                new GraphTexture("depthPlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 4, mips: 0),
                new GraphTexture("mask", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 4),
                new GraphTexture("resolved", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("rows", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("half", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor: 2),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "QuarterDepthPlanes",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "DepthPlanesMip",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(0) },
                    eachMip = true,
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "ConservativeMask",
                    reads = new[] { GraphBinding.Texture("_PenumbraDepthPlanesTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraMaskTexture", 1) },
                    absent = new[] { "_PenumbraSourceTexture" },
                    writes = new[] { GraphBinding.Texture(5) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 5) },
                    absent = new[] { "_PenumbraMaskTexture" },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseHorizontal",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 2) },
                    writes = new[] { GraphBinding.Texture(3) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "DenoiseVertical",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 3) },
                    writes = new[] { GraphBinding.Texture(4) },
                },
            },
            visibility = 4,
            mask = 1,
        };
    }
}
