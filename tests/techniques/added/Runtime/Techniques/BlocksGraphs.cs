using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Blocks.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class BlocksGraphs
    {
        internal static readonly TechniqueGraph Blocks = new TechniqueGraph
        {
            name = "blocks",
            textures = new[]
            {
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R32_SFloat),
                new GraphTexture("marks", GraphExtent.Screen, GraphicsFormat.R32_UInt, divisor: 8),
                new GraphTexture("halves", GraphExtent.Screen, GraphicsFormat.R32_UInt, divisor: 8, mips: 2),
            },
            buffers = new[]
            {
                new GraphBuffer("groups", words: 3, indirect: true),
                new GraphBuffer("list", wordsPerTexel: 1, texture: 1),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Blocks.compute",
                    program = "Mark",
                    writes = new[] { GraphBinding.Texture("_Marks", 1), GraphBinding.Texture("_Sums", 2) },
                    groups = GraphGroups.TexelsOf(1),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Blocks.compute",
                    program = "Collect",
                    reads = new[] { GraphBinding.Texture("_MarksRead", 1) },
                    writes = new[] { GraphBinding.Buffer("_Groups", 0), GraphBinding.Buffer("_List", 1) },
                    groups = GraphGroups.Fixed(1, 1, 1),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Blocks.compute",
                    program = "Sum",
                    reads = new[] { GraphBinding.Texture("_Before", 2) },
                    writes = new[] { GraphBinding.Texture("_Sums", 2) },
                    eachMip = true,
                    groups = GraphGroups.TexelsOf(2),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Blocks.compute",
                    program = "Shade",
                    reads = new[] { GraphBinding.Texture("_Halves", 2), GraphBinding.Buffer("_List", 1) },
                    writes = new[] { GraphBinding.Texture("_Visibility", 0) },
                    groups = GraphGroups.Indirect(0),
                },
            },
            visibility = 0,
        };
    }
}
