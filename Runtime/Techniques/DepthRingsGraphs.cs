using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Cells/DepthRings.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class DepthRingsGraphs
    {
        internal static readonly TechniqueGraph DepthRings = new TechniqueGraph
        {
            name = "depth-rings",
            textures = new[]
            {
                new GraphTexture("depthPlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 4),
                new GraphTexture("depthSpreads", GraphExtent.Map, GraphicsFormat.R32G32B32A32_UInt, divisor: 4),
                new GraphTexture("coarsePlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 8, mips: 0),
                new GraphTexture("coarseSpreads", GraphExtent.Map, GraphicsFormat.R32G32B32A32_UInt, divisor: 8, mips: 0),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "QuarterDepthBlocks",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0), GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "EighthDepthBlocks",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourcePlanes", 0), GraphBinding.Texture("_PenumbraSourceSpreads", 1) },
                    writes = new[] { GraphBinding.Texture(2), GraphBinding.Texture(3) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "DepthBlocksMip",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourcePlanes", 2), GraphBinding.Texture("_PenumbraSourceSpreads", 3) },
                    writes = new[] { GraphBinding.Texture(2), GraphBinding.Texture(3) },
                    eachMip = true,
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraDepthPlanesTexture", 0), GraphBinding.Texture("_PenumbraDepthSpreadsTexture", 1), GraphBinding.Texture("_PenumbraCoarsePlanesTexture", 2), GraphBinding.Texture("_PenumbraCoarseSpreadsTexture", 3) },
        };
    }
}
