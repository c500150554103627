using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Opacity/OpacityMask.technique.json; do not edit.
    /// <summary>The manifest's graphs; passes are listed in the order in which they run.</summary>
    internal static class OpacityMaskGraphs
    {
        internal static readonly TechniqueGraph SingleLoopOpacity = new TechniqueGraph
        {
            name = "single-loop-opacity",
            textures = new[]
            {
                new GraphTexture("opacityMask", GraphExtent.Map, GraphicsFormat.R8_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Casters,
                    asset = "Shaders/PenumbraOpacity.shader",
                    program = "BlendedOpacity",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                    blended = true,
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraOpacityMaskTexture", 0) },
            filtersLinearly = true,
        };

        internal static readonly TechniqueGraph PcssAngularOpacity = new TechniqueGraph
        {
            name = "pcss-angular-opacity",
            textures = new[]
            {
                new GraphTexture("opacityMask", GraphExtent.Map, GraphicsFormat.R8_UNorm),
                new GraphTexture("blendedDepth", GraphExtent.Map, GraphicsFormat.D16_UNorm),
            },
            passes = new[]
            {
                new GraphPass
                {
                    kind = PassKind.Casters,
                    asset = "Shaders/PenumbraOpacity.shader",
                    program = "BlendedOpacity",
                    runs = PassFrequency.Cascade,
                    writes = new[] { GraphBinding.Texture(0) },
                    blended = true,
                },
                new GraphPass
                {
                    kind = PassKind.Casters,
                    asset = "Shaders/PenumbraOpacity.shader",
                    program = "BlendedDepth",
                    runs = PassFrequency.Cascade,
                    depth = 1,
                    blended = true,
                },
            },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraOpacityMaskTexture", 0), GraphBinding.Texture("_PenumbraBlendedDepthTexture", 1) },
        };
    }
}
