using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraFar.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class PenumbraFarGraphs
    {
        internal static readonly TechniqueGraph FarHorizon = new TechniqueGraph
        {
            name = "far-horizon",
            textures = new[]
            {
                new GraphTexture("near", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("far", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFar.shader",
                    program = "FarShadows",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
            },
            keywords = new[] { "_PENUMBRA_FAR_HORIZON" },
            visibility = 1,
            source = 0,
        };

        internal static readonly TechniqueGraph FarHeights = new TechniqueGraph
        {
            name = "far-heights",
            textures = new[]
            {
                new GraphTexture("near", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("far", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFar.shader",
                    program = "FarShadows",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
            },
            keywords = new[] { "_PENUMBRA_FAR_HEIGHTS" },
            visibility = 1,
            source = 0,
        };

        internal static readonly TechniqueGraph FarHorizonClouds = new TechniqueGraph
        {
            name = "far-horizon-clouds",
            textures = new[]
            {
                new GraphTexture("clouds", GraphExtent.Fixed, GraphicsFormat.R16_UNorm, width: 512, height: 512),
                new GraphTexture("near", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("far", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFar.shader",
                    program = "CloudMap",
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFar.shader",
                    program = "FarShadows",
                    reads = new[] { GraphBinding.Texture("_PenumbraCloudTexture", 0), GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
            },
            keywords = new[] { "_PENUMBRA_FAR_HORIZON", "_PENUMBRA_CLOUDS" },
            visibility = 2,
            source = 1,
        };

        internal static readonly TechniqueGraph FarHeightsClouds = new TechniqueGraph
        {
            name = "far-heights-clouds",
            textures = new[]
            {
                new GraphTexture("clouds", GraphExtent.Fixed, GraphicsFormat.R16_UNorm, width: 512, height: 512),
                new GraphTexture("near", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("far", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFar.shader",
                    program = "CloudMap",
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFar.shader",
                    program = "FarShadows",
                    reads = new[] { GraphBinding.Texture("_PenumbraCloudTexture", 0), GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
            },
            keywords = new[] { "_PENUMBRA_FAR_HEIGHTS", "_PENUMBRA_CLOUDS" },
            visibility = 2,
            source = 1,
        };

        internal static readonly TechniqueGraph Clouds = new TechniqueGraph
        {
            name = "clouds",
            textures = new[]
            {
                new GraphTexture("clouds", GraphExtent.Fixed, GraphicsFormat.R16_UNorm, width: 512, height: 512),
                new GraphTexture("near", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("far", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFar.shader",
                    program = "CloudMap",
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFar.shader",
                    program = "FarShadows",
                    reads = new[] { GraphBinding.Texture("_PenumbraCloudTexture", 0), GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
            },
            keywords = new[] { "_PENUMBRA_CLOUDS" },
            visibility = 2,
            source = 1,
        };

        internal static readonly TechniqueGraph HorizonAlone = new TechniqueGraph
        {
            name = "horizon-alone",
            textures = new[]
            {
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFar.shader",
                    program = "FarShadowsAlone",
                    writes = new[] { GraphBinding.Texture(0) },
                },
            },
            keywords = new[] { "_PENUMBRA_FAR_HORIZON" },
            visibility = 0,
        };

        internal static readonly TechniqueGraph HeightsAlone = new TechniqueGraph
        {
            name = "heights-alone",
            textures = new[]
            {
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFar.shader",
                    program = "FarShadowsAlone",
                    writes = new[] { GraphBinding.Texture(0) },
                },
            },
            keywords = new[] { "_PENUMBRA_FAR_HEIGHTS" },
            visibility = 0,
        };
    }
}
