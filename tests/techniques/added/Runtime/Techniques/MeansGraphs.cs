using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Means.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class MeansGraphs
    {
        internal static readonly TechniqueGraph Means = new TechniqueGraph
        {
            name = "means",
            textures = new[]
            {
                new GraphTexture("depths", GraphExtent.Map, GraphicsFormat.R32_SFloat),
                new GraphTexture("rows", GraphExtent.Map, GraphicsFormat.R32_SFloat),
                new GraphTexture("blurred", GraphExtent.Map, GraphicsFormat.R32_SFloat, mips: 2),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Means.shader",
                    program = "Depths",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Means.shader",
                    program = "Rows",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Means.shader",
                    program = "Columns",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Means.shader",
                    program = "Mips",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 2) },
                    writes = new[] { GraphBinding.Texture(2) },
                    eachMip = true,
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraBlurredTexture", 2) },
        };
    }
}
