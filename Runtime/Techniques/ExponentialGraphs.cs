using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Exponential.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class ExponentialGraphs
    {
        internal static readonly TechniqueGraph Exponential32 = new TechniqueGraph
        {
            name = "exponential-32",
            textures = new[]
            {
                new GraphTexture("rows", GraphExtent.Map, GraphicsFormat.R32_SFloat),
                new GraphTexture("exponentials", GraphExtent.Map, GraphicsFormat.R32_SFloat),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "ExponentialRows",
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
            filterTextures = new[] { GraphBinding.Texture("_PenumbraExponentialsTexture", 1) },
            filtersLinearly = true,
        };

        internal static readonly TechniqueGraph Exponential16 = new TechniqueGraph
        {
            name = "exponential-16",
            textures = new[]
            {
                new GraphTexture("rows", GraphExtent.Map, GraphicsFormat.R16_SFloat),
                new GraphTexture("exponentials", GraphExtent.Map, GraphicsFormat.R16_SFloat),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "ExponentialRows",
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
            filterTextures = new[] { GraphBinding.Texture("_PenumbraExponentialsTexture", 1) },
            filtersLinearly = true,
        };
    }
}
