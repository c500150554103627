using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Mssm.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class MssmGraphs
    {
        internal static readonly TechniqueGraph MssmSat32 = new TechniqueGraph
        {
            name = "mssm-sat-32",
            textures = new[]
            {
                new GraphTexture("values", GraphExtent.Map, GraphicsFormat.R32G32B32A32_UInt),
                new GraphTexture("rows", GraphExtent.Map, GraphicsFormat.R32G32B32A32_UInt),
                new GraphTexture("sums", GraphExtent.Map, GraphicsFormat.R32G32B32A32_UInt),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "MomentDigits",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/SummedAreas.compute",
                    program = "SumRows",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraValues", 0) },
                    writes = new[] { GraphBinding.Texture("_PenumbraSums", 1) },
                    groups = GraphGroups.TexelsOf(1),
                },
                new GraphPass
                {
                    kind = PassKind.Compute,
                    asset = "Shaders/SummedAreas.compute",
                    program = "SumColumns",
                    runs = PassFrequency.Cascade,
                    reads = new[] { GraphBinding.Texture("_PenumbraValues", 1) },
                    writes = new[] { GraphBinding.Texture("_PenumbraSums", 2) },
                    groups = GraphGroups.TexelsOf(2),
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraSumsTexture", 2) },
        };

        internal static readonly TechniqueGraph MssmMip16 = new TechniqueGraph
        {
            name = "mssm-mip-16",
            textures = new[]
            {
                new GraphTexture("moments", GraphExtent.Map, GraphicsFormat.R16G16B16A16_UNorm, mips: 0),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraMaps.shader",
                    program = "MomentLevel",
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
