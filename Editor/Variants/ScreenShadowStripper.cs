using UnityEditor.Rendering;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>
    /// Keeps the variants of receivers that read the screen-space texture. A variant goes only when every stripper lets
    /// it go, and URP's own lets these go unless its own Screen Space Shadows feature is there: so this one objects,
    /// while a renderer of the project has the feature. Transparents never read the texture, and without a deferred
    /// renderer nobody draws a G-buffer. What URP would drop for yet another reason (a light cookie that no light has)
    /// stays: strippers are not told the others' reasons. For Meta Quest, where nobody draws them, it objects to nothing.
    /// </summary>
    internal sealed class ScreenShadowStripper : IShaderVariantStripper
    {
        private const string GBufferPass = "GBuffer";

        // Of Deferred, and of Deferred+.
        private const string StencilLighting = "Hidden/Universal Render Pipeline/StencilDeferred";
        private const string ClusterLighting = "Hidden/Universal Render Pipeline/ClusterDeferred";

        private static readonly ShaderKeyword Screen = new ShaderKeyword(ShadowKeywords.ScreenName);
        private static readonly ShaderKeyword Transparent = new ShaderKeyword("_SURFACE_TYPE_TRANSPARENT");

        private bool anyDeferred;

        // Read once before a shader's variants are asked about.
        public bool active
        {
            get
            {
                anyDeferred = FeaturesInProject.AnyDeferred;
                return FeaturesInProject.Any && !UrpFrame.MetaQuest;
            }
        }

        public bool CanRemoveVariant(Shader shader, ShaderSnippetData shaderVariant,
                                     ShaderCompilerData shaderCompilerData) =>
            CanRemove(shaderCompilerData.shaderKeywordSet.IsEnabled(Screen),
                      shaderCompilerData.shaderKeywordSet.IsEnabled(Transparent),
                      !anyDeferred && IsOfDeferred(shader.name, shaderVariant.passName));

        internal static bool IsOfDeferred(string shader, string pass) =>
            pass == GBufferPass || shader == StencilLighting || shader == ClusterLighting;

        internal static bool CanRemove(bool readsScreenTexture, bool isTransparent, bool isDrawnByNobody) =>
            !readsScreenTexture || isTransparent || isDrawnByNobody;
    }
}
