using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/SingleLoop/SingleLoop.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class SingleLoopGraphs
    {
        internal static readonly TechniqueGraph SingleLoopMinmax = new TechniqueGraph
        {
            name = "single-loop-minmax",
            textures = new[]
            {
                new GraphTexture("quarter", GraphExtent.Map, GraphicsFormat.R16G16_UNorm, divisor: 4),
                new GraphTexture("depthRanges", GraphExtent.Map, GraphicsFormat.R16G16_UNorm, divisor: 4),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "QuarterDepthRange",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "DilatedDepthRange",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraDepthRangesTexture", 1) },
        };

        internal static readonly TechniqueGraph SingleLoopMips = new TechniqueGraph
        {
            name = "single-loop-mips",
            textures = new[]
            {
                new GraphTexture("depthRanges", GraphExtent.Map, GraphicsFormat.R16G16_UNorm, divisor: 4, mips: 0),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "QuarterDepthRange",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "DepthRangeMip",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(0) },
                    eachMip = true,
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraDepthRangesTexture", 0) },
        };

        internal static readonly TechniqueGraph SingleLoopPlanes = new TechniqueGraph
        {
            name = "single-loop-planes",
            textures = new[]
            {
                new GraphTexture("depthPlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 4, mips: 0),
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
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraDepthPlanesTexture", 0) },
        };
    }
}
