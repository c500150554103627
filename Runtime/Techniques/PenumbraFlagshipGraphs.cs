using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraFlagship.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class PenumbraFlagshipGraphs
    {
        internal static readonly TechniqueGraph Flagship = new TechniqueGraph
        {
            name = "flagship",
            textures = new[]
            {
                new GraphTexture("depthPlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 4),
                new GraphTexture("depthSpreads", GraphExtent.Map, GraphicsFormat.R32G32B32A32_UInt, divisor: 4),
                new GraphTexture("coarsePlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 8, mips: 0),
                new GraphTexture("coarseSpreads", GraphExtent.Map, GraphicsFormat.R32G32B32A32_UInt, divisor: 8, mips: 0),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R32_SFloat),
            },
            buffers = new[]
            {
                new GraphBuffer("tileGroups", words: 3, indirect: true),
                new GraphBuffer("restGroups", words: 3, indirect: true),
                new GraphBuffer("aloneGroups", words: 3, indirect: true),
                new GraphBuffer("tileCounts", words: 3),
                new GraphBuffer("tileList", wordsPerTexel: 17, texture: 4, divisor: 16),
                new GraphBuffer("restList", wordsPerTexel: 17, texture: 4, divisor: 16),
                new GraphBuffer("aloneList", wordsPerTexel: 16, texture: 4, divisor: 16),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "FirstLevels",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture("_PenumbraCoarseDepthPlaneTarget", 2), GraphBinding.Texture("_PenumbraCoarseSpreadTarget", 3), GraphBinding.Texture("_PenumbraDepthPlaneTarget", 0), GraphBinding.Texture("_PenumbraSpreadTarget", 1) },
                    groups = GraphGroups.TexelsOf(0),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "NextLevel",
                    reads = new[] { GraphBinding.Texture("_PenumbraCoarseDepthPlanes", 2), GraphBinding.Texture("_PenumbraCoarseSpreads", 3) },
                    writes = new[] { GraphBinding.Texture("_PenumbraCoarseDepthPlaneTarget", 2), GraphBinding.Texture("_PenumbraCoarseSpreadTarget", 3) },
                    eachMip = true,
                    groups = GraphGroups.TexelsOf(2),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "ResetTiles",
                    writes = new[] { GraphBinding.Buffer("_PenumbraAloneGroups", 2), GraphBinding.Buffer("_PenumbraRestGroups", 1), GraphBinding.Buffer("_PenumbraTileCounts", 3), GraphBinding.Buffer("_PenumbraTileGroups", 0) },
                    groups = GraphGroups.Fixed(1, 1, 1),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "ClassifyTiles",
                    reads = new[] { GraphBinding.Texture("_PenumbraCoarseDepthPlanes", 2), GraphBinding.Texture("_PenumbraDepthPlanes", 0) },
                    writes = new[] { GraphBinding.Buffer("_PenumbraTileList", 4), GraphBinding.Texture("_PenumbraVisibility", 4) },
                    updates = new[] { GraphBinding.Buffer("_PenumbraTileCounts", 3), GraphBinding.Buffer("_PenumbraTileGroups", 0) },
                    groups = GraphGroups.TexelsOf(4, divisor: 4),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "ResolveTiles",
                    reads = new[] { GraphBinding.Texture("_PenumbraCoarseSpreads", 3), GraphBinding.Texture("_PenumbraSpreads", 1), GraphBinding.Buffer("_PenumbraTileList", 4) },
                    writes = new[] { GraphBinding.Buffer("_PenumbraRestList", 5) },
                    updates = new[] { GraphBinding.Buffer("_PenumbraRestGroups", 1), GraphBinding.Buffer("_PenumbraTileCounts", 3), GraphBinding.Texture("_PenumbraVisibility", 4) },
                    groups = GraphGroups.Indirect(0),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "ResolveRest",
                    reads = new[] { GraphBinding.Texture("_PenumbraCoarseSpreads", 3), GraphBinding.Texture("_PenumbraSpreads", 1) },
                    writes = new[] { GraphBinding.Buffer("_PenumbraAloneList", 6) },
                    updates = new[] { GraphBinding.Buffer("_PenumbraAloneGroups", 2), GraphBinding.Buffer("_PenumbraRestList", 5), GraphBinding.Buffer("_PenumbraTileCounts", 3), GraphBinding.Texture("_PenumbraVisibility", 4) },
                    groups = GraphGroups.Indirect(1),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "ResolveAlone",
                    reads = new[] { GraphBinding.Buffer("_PenumbraAloneList", 6), GraphBinding.Texture("_PenumbraCoarseSpreads", 3), GraphBinding.Buffer("_PenumbraRestList", 5), GraphBinding.Texture("_PenumbraSpreads", 1), GraphBinding.Buffer("_PenumbraTileCounts", 3) },
                    updates = new[] { GraphBinding.Texture("_PenumbraVisibility", 4) },
                    groups = GraphGroups.Indirect(2),
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraDepthPlanesTexture", 0), GraphBinding.Texture("_PenumbraDepthSpreadsTexture", 1), GraphBinding.Texture("_PenumbraCoarsePlanesTexture", 2), GraphBinding.Texture("_PenumbraCoarseSpreadsTexture", 3) },
            visibility = 4,
        };

        internal static readonly TechniqueGraph FlagshipHalf = new TechniqueGraph
        {
            name = "flagship-half",
            textures = new[]
            {
                new GraphTexture("depthPlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 4),
                new GraphTexture("depthSpreads", GraphExtent.Map, GraphicsFormat.R32G32B32A32_UInt, divisor: 4),
                new GraphTexture("coarsePlanes", GraphExtent.Map, GraphicsFormat.R32G32B32A32_SFloat, divisor: 8, mips: 0),
                new GraphTexture("coarseSpreads", GraphExtent.Map, GraphicsFormat.R32G32B32A32_UInt, divisor: 8, mips: 0),
                new GraphTexture("half", GraphExtent.Screen, GraphicsFormat.R32_SFloat, divisor: 2),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            buffers = new[]
            {
                new GraphBuffer("tileGroups", words: 3, indirect: true),
                new GraphBuffer("restGroups", words: 3, indirect: true),
                new GraphBuffer("aloneGroups", words: 3, indirect: true),
                new GraphBuffer("tileCounts", words: 3),
                new GraphBuffer("tileList", wordsPerTexel: 17, texture: 4, divisor: 16),
                new GraphBuffer("restList", wordsPerTexel: 17, texture: 4, divisor: 16),
                new GraphBuffer("aloneList", wordsPerTexel: 16, texture: 4, divisor: 16),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "FirstLevels",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture("_PenumbraCoarseDepthPlaneTarget", 2), GraphBinding.Texture("_PenumbraCoarseSpreadTarget", 3), GraphBinding.Texture("_PenumbraDepthPlaneTarget", 0), GraphBinding.Texture("_PenumbraSpreadTarget", 1) },
                    groups = GraphGroups.TexelsOf(0),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "NextLevel",
                    reads = new[] { GraphBinding.Texture("_PenumbraCoarseDepthPlanes", 2), GraphBinding.Texture("_PenumbraCoarseSpreads", 3) },
                    writes = new[] { GraphBinding.Texture("_PenumbraCoarseDepthPlaneTarget", 2), GraphBinding.Texture("_PenumbraCoarseSpreadTarget", 3) },
                    eachMip = true,
                    groups = GraphGroups.TexelsOf(2),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "ResetTiles",
                    writes = new[] { GraphBinding.Buffer("_PenumbraAloneGroups", 2), GraphBinding.Buffer("_PenumbraRestGroups", 1), GraphBinding.Buffer("_PenumbraTileCounts", 3), GraphBinding.Buffer("_PenumbraTileGroups", 0) },
                    groups = GraphGroups.Fixed(1, 1, 1),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "ClassifyTiles",
                    reads = new[] { GraphBinding.Texture("_PenumbraCoarseDepthPlanes", 2), GraphBinding.Texture("_PenumbraDepthPlanes", 0) },
                    writes = new[] { GraphBinding.Buffer("_PenumbraTileList", 4), GraphBinding.Texture("_PenumbraVisibility", 4) },
                    updates = new[] { GraphBinding.Buffer("_PenumbraTileCounts", 3), GraphBinding.Buffer("_PenumbraTileGroups", 0) },
                    groups = GraphGroups.TexelsOf(4, divisor: 4),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "ResolveTiles",
                    reads = new[] { GraphBinding.Texture("_PenumbraCoarseSpreads", 3), GraphBinding.Texture("_PenumbraSpreads", 1), GraphBinding.Buffer("_PenumbraTileList", 4) },
                    writes = new[] { GraphBinding.Buffer("_PenumbraRestList", 5) },
                    updates = new[] { GraphBinding.Buffer("_PenumbraRestGroups", 1), GraphBinding.Buffer("_PenumbraTileCounts", 3), GraphBinding.Texture("_PenumbraVisibility", 4) },
                    groups = GraphGroups.Indirect(0),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "ResolveRest",
                    reads = new[] { GraphBinding.Texture("_PenumbraCoarseSpreads", 3), GraphBinding.Texture("_PenumbraSpreads", 1) },
                    writes = new[] { GraphBinding.Buffer("_PenumbraAloneList", 6) },
                    updates = new[] { GraphBinding.Buffer("_PenumbraAloneGroups", 2), GraphBinding.Buffer("_PenumbraRestList", 5), GraphBinding.Buffer("_PenumbraTileCounts", 3), GraphBinding.Texture("_PenumbraVisibility", 4) },
                    groups = GraphGroups.Indirect(1),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/PenumbraFlagship.compute",
                    program = "ResolveAlone",
                    reads = new[] { GraphBinding.Buffer("_PenumbraAloneList", 6), GraphBinding.Texture("_PenumbraCoarseSpreads", 3), GraphBinding.Buffer("_PenumbraRestList", 5), GraphBinding.Texture("_PenumbraSpreads", 1), GraphBinding.Buffer("_PenumbraTileCounts", 3) },
                    updates = new[] { GraphBinding.Texture("_PenumbraVisibility", 4) },
                    groups = GraphGroups.Indirect(2),
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraShadows.shader",
                    program = "Resolve",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 4) },
                    absent = new[] { "_PenumbraMaskTexture" },
                    writes = new[] { GraphBinding.Texture(5) },
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraDepthPlanesTexture", 0), GraphBinding.Texture("_PenumbraDepthSpreadsTexture", 1), GraphBinding.Texture("_PenumbraCoarsePlanesTexture", 2), GraphBinding.Texture("_PenumbraCoarseSpreadsTexture", 3) },
            visibility = 5,
        };
    }
}
