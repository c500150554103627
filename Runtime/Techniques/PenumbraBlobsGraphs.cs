using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraBlobs.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class PenumbraBlobsGraphs
    {
        internal static readonly TechniqueGraph Blob = new TechniqueGraph
        {
            name = "blob",
            textures = new[]
            {
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraBlobs.shader",
                    program = "Blobs",
                    writes = new[] { GraphBinding.Texture(0) },
                },
            },
            visibility = 0,
        };
    }
}
