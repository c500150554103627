using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Layers.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class LayersGraphs
    {
        internal static readonly TechniqueGraph Layers = new TechniqueGraph
        {
            name = "layers",
            textures = new[]
            {
                new GraphTexture("nearest", GraphExtent.Map, GraphicsFormat.D32_SFloat),
                new GraphTexture("layers", GraphExtent.Map, GraphicsFormat.R32_SFloat),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Casters,
                    asset = "Layers.shader",
                    program = "Layers",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(1) },
                },
                new GraphPass
                {
                    kind = PassKind.Casters,
                    asset = "Layers.shader",
                    program = "Nearest",
                    runs = PassFrequency.Cascade,
                    depth = 0,
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraNearestTexture", 0), GraphBinding.Texture("_PenumbraLayersTexture", 1) },
        };
    }
}
