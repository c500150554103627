using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/VarianceMultisampled.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class VarianceMultisampledGraphs
    {
        internal static readonly TechniqueGraph Variance32Multisampled = new TechniqueGraph
        {
            name = "variance-32-multisampled",
            textures = new[]
            {
                new GraphTexture("depths", GraphExtent.Map, GraphicsFormat.D32_SFloat, samples: 4),
                new GraphTexture("values", GraphExtent.Map, GraphicsFormat.R32G32_SFloat),
                new GraphTexture("rows", GraphExtent.Map, GraphicsFormat.R32G32_SFloat),
                new GraphTexture("moments", GraphExtent.Map, GraphicsFormat.R32G32_SFloat),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Casters,
                    asset = "Shaders/PenumbraMultisampledMaps.shader",
                    program = "CasterDepth",
                    runs = PassFrequency.Cascade,
                    depth = 0,
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMultisampledMaps.shader",
                    program = "MeanOfDepths",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSampleDepths", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMultisampledMaps.shader",
                    program = "ValueRows",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 1) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "MapColumns",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 2) },
                    writes = new[] { GraphBinding.Texture(3) },
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraMomentsTexture", 3) },
            filtersLinearly = true,
        };
    }
}
