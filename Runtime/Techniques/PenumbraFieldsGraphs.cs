using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraFields.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class PenumbraFieldsGraphs
    {
        internal static readonly TechniqueGraph DistanceFieldHard = new TechniqueGraph
        {
            name = "distance-field-hard",
            textures = new[]
            {
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFields.shader",
                    program = "FieldShadows",
                    writes = new[] { GraphBinding.Texture(0) },
                },
            },
            keywords = new[] { "_PENUMBRA_FIELD_HARD" },
            visibility = 0,
        };

        internal static readonly TechniqueGraph DistanceFieldCone = new TechniqueGraph
        {
            name = "distance-field-cone",
            textures = new[]
            {
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFields.shader",
                    program = "FieldShadows",
                    writes = new[] { GraphBinding.Texture(0) },
                },
            },
            keywords = new[] { "_PENUMBRA_FIELD_CONE" },
            visibility = 0,
        };

        internal static readonly TechniqueGraph DistanceFieldSoft = new TechniqueGraph
        {
            name = "distance-field-soft",
            textures = new[]
            {
                new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Raster,
                    asset = "Shaders/PenumbraFields.shader",
                    program = "FieldShadows",
                    writes = new[] { GraphBinding.Texture(0) },
                },
            },
            visibility = 0,
        };
    }
}
