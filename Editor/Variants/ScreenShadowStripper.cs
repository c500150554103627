using UnityEditor.Rendering;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>
    /// Keeps the variants of receivers that read the screen-space texture. A variant goes only when every stripper lets
    /// it go, and URP's own lets these go unless its own Screen Space Shadows feature is there: so this one objects,
    /// while a renderer of the project has the feature. Transparents never read the texture.
    /// </summary>
    internal sealed class ScreenShadowStripper : IShaderVariantStripper
    {
        private static readonly ShaderKeyword Screen = new ShaderKeyword(ShadowKeywords.ScreenName);
        private static readonly ShaderKeyword Transparent = new ShaderKeyword("_SURFACE_TYPE_TRANSPARENT");

        public bool active => FeaturesInProject.Any;

        public bool CanRemoveVariant(Shader shader, ShaderSnippetData shaderVariant,
                                     ShaderCompilerData shaderCompilerData) =>
            CanRemove(shaderCompilerData.shaderKeywordSet.IsEnabled(Screen),
                      shaderCompilerData.shaderKeywordSet.IsEnabled(Transparent));

        internal static bool CanRemove(bool readsScreenTexture, bool isTransparent) =>
            !readsScreenTexture || isTransparent;
    }
}
