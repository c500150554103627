using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Variance.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class VarianceGraphs
    {
        internal static readonly TechniqueGraph Variance32 = new TechniqueGraph
        {
            name = "variance-32",
            textures = new[]
            {
                new GraphTexture("rows", GraphExtent.Map, GraphicsFormat.R32G32_SFloat),
                new GraphTexture("moments", GraphExtent.Map, GraphicsFormat.R32G32_SFloat),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "VarianceRows",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "MapColumns",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraMomentsTexture", 1) },
            filtersLinearly = true,
        };

        internal static readonly TechniqueGraph Variance16 = new TechniqueGraph
        {
            name = "variance-16",
            textures = new[]
            {
                new GraphTexture("rows", GraphExtent.Map, GraphicsFormat.R16G16_SFloat),
                new GraphTexture("moments", GraphExtent.Map, GraphicsFormat.R16G16_SFloat),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "VarianceRows",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "MapColumns",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraMomentsTexture", 1) },
            filtersLinearly = true,
        };
    }
}
