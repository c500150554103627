using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/ExponentialLevels.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class ExponentialLevelsGraphs
    {
        internal static readonly TechniqueGraph EvsmMip = new TechniqueGraph
        {
            name = "evsm-mip",
            textures = new[]
            {
                new GraphTexture("moments", GraphExtent.Map, GraphicsFormat.R16G16B16A16_SFloat, mips: 0),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "ExponentialVarianceLevel",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "NextLevel",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(0) },
                    eachMip = true,
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraMomentsTexture", 0) },
            filtersLinearly = true,
        };
    }
}
