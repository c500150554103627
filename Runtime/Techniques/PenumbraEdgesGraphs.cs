using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraEdges.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class PenumbraEdgesGraphs
    {
        internal static readonly TechniqueGraph PcssSampleEdges = new TechniqueGraph
        {
            name = "pcss-sample-edges",
            textures = new[]
            {
                new GraphTexture("sampleNormals", GraphExtent.Screen, GraphicsFormat.R16G16B16A16_SFloat, samples: 4),
                new GraphTexture("sampleDepths", GraphExtent.Screen, GraphicsFormat.D32_SFloat, samples: 4),
                new GraphTexture("different", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("edges", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("pixels", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
                new GraphTexture("samples", GraphExtent.Screen, GraphicsFormat.R8_UNorm, samples: 4),
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Casters,
                    asset = "Shaders/PenumbraEdges.shader",
                    program = "SampleSurface",
                    writes = new[] { GraphBinding.Texture(0) },
                    depth = 1,
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraEdges.shader",
                    program = "MarkSamples",
                    reads = new[] { GraphBinding.Texture("_PenumbraSampleNormals", 0) },
                    writes = new[] { GraphBinding.Texture(2) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraEdges.shader",
                    program = "MarkSurfaces",
                    reads = new[] { GraphBinding.Texture("_PenumbraSampleDepths", 1), GraphBinding.Texture("_PenumbraSampleNormals", 0), GraphBinding.Texture("_PenumbraSourceTexture", 2) },
                    writes = new[] { GraphBinding.Texture(3) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraEdges.shader",
                    program = "ShadePixels",
                    reads = new[] { GraphBinding.Texture("_PenumbraEdgeTexture", 3) },
                    writes = new[] { GraphBinding.Texture(4) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraEdges.shader",
                    program = "ShadeSamples",
                    reads = new[] { GraphBinding.Texture("_PenumbraEdgeTexture", 3), GraphBinding.Texture("_PenumbraSampleDepths", 1), GraphBinding.Texture("_PenumbraSampleNormals", 0) },
                    writes = new[] { GraphBinding.Texture(5) },
                },
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraEdges.shader",
                    program = "MeanOfSamples",
                    reads = new[] { GraphBinding.Texture("_PenumbraEdgeTexture", 3), GraphBinding.Texture("_PenumbraPixelTexture", 4), GraphBinding.Texture("_PenumbraSampleTexture", 5) },
                    writes = new[] { GraphBinding.Texture(6) },
                },
            },
            visibility = 6,
        };
    }
}
