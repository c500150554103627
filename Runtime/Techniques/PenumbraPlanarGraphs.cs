using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraPlanar.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class PenumbraPlanarGraphs
    {
        internal static readonly TechniqueGraph Planar = new TechniqueGraph
        {
            name = "planar",
            textures = new[]
            {
                new GraphTexture("shadow", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Casters,
                    asset = "Shaders/PenumbraPlanar.shader",
                    program = "PlanarShadow",
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraPlanar.shader",
                    program = "PlanarVisibility",
                    reads = new[] { GraphBinding.Texture("_PenumbraSourceTexture", 0) },
                    writes = new[] { GraphBinding.Texture(1) },
                },
            },
            visibility = 1,
        };
    }
}
