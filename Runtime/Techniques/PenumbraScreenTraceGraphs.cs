using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraScreenTrace.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class PenumbraScreenTraceGraphs
    {
        internal static readonly TechniqueGraph ScreenTraceAlone = new TechniqueGraph
        {
            name = "screen-trace-alone",
            textures = new[]
            {
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraScreenTrace.shader",
                    program = "ScreenTraceAlone",
                    writes = new[] { GraphBinding.Texture(0) },
                },
            },
            visibility = 0,
        };

        internal static readonly TechniqueGraph ScreenTrace = new TechniqueGraph
        {
            name = "screen-trace",
            textures = new[]
            {
                new GraphTexture("filtered", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("traced", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraScreenTrace.shader",
                    program = "ScreenTrace",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
            },
            visibility = 1,
            source = 0,
        };
    }
}
