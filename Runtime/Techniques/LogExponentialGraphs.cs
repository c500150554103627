using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/LogExponential.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class LogExponentialGraphs
    {
        internal static readonly TechniqueGraph LogExponential16 = new TechniqueGraph
        {
            name = "log-exponential-16",
            textures = new[]
            {
                new GraphTexture("rows", GraphExtent.Map, GraphicsFormat.R16_UNorm),
                new GraphTexture("softDepths", GraphExtent.Map, GraphicsFormat.R16_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "LogExponentialRows",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "LogExponentialColumns",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraSoftDepthsTexture", 1) },
        };
    }
}
