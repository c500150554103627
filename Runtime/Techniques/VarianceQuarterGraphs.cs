using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/VarianceQuarter.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class VarianceQuarterGraphs
    {
        internal static readonly TechniqueGraph VarianceQuarter = new TechniqueGraph
        {
            name = "variance-quarter",
            textures = new[]
            {
                new GraphTexture("quarterMoments", GraphExtent.Map, GraphicsFormat.R32G32_SFloat, divisor: 4),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "QuarterVariance",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraQuarterMomentsTexture", 0) },
            filtersLinearly = true,
        };
    }
}
