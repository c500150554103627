using UnityEditor.Rendering;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>
    /// Keeps the receivers' variants that read the screen-space texture. Unity removes a variant only if all
    /// strippers agree, and URP's own agrees unless its Screen Space Shadows feature is present: so this one
    /// disagrees while a renderer of the project has the Penumbra feature. It does not keep transparents' variants,
    /// which never read the texture, nor G-buffer variants without a deferred renderer. Variants that URP would
    /// remove for other reasons (a light cookie that no light has) stay, as strippers do not know each other's
    /// reasons. For Meta Quest, where the feature draws nothing, it keeps none.
    /// </summary>
    internal sealed class ScreenShadowStripper : IShaderVariantStripper
    {
        private const string GBufferPass = "GBuffer";

        // The shader of the Deferred and the Deferred+ rendering path.
        private const string StencilLighting = "Hidden/Universal Render Pipeline/StencilDeferred";
        private const string ClusterLighting = "Hidden/Universal Render Pipeline/ClusterDeferred";

        private static readonly ShaderKeyword Screen = new ShaderKeyword(ShadowKeywords.ScreenName);
        private static readonly ShaderKeyword Transparent = new ShaderKeyword("_SURFACE_TYPE_TRANSPARENT");

        private bool anyDeferred;

        // Unity reads this once before the variants of a shader are passed in.
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
