using UnityEngine.Rendering;
using UnityEngine.Scripting;

namespace Penumbra
{
    /// <summary>
    /// Blurs the noise of the samples away, not across edges, at the screen's resolution.
    /// Library: ShaderLibrary/Screen/EdgeDenoise.hlsl.
    /// </summary>
    [Preserve]
    internal sealed class DenoisePass : ShadowPass
    {
        internal override int Order => 400;

        /// <summary>Tents have no noise.</summary>
        internal override bool IsNeeded(in ShadowOptions options) =>
            options.denoise && options.SamplesPenumbrae;

        internal override void AddSteps(ShadowChain chain, in ShadowOptions options)
        {
            int rows = chain.Draw("DenoiseHorizontal", 1, chain.Visibility);
            chain.SetVisibility(chain.Draw("DenoiseVertical", 1, rows));
        }

        internal override void SetUniforms(CommandBuffer commands, in ShadowFrame frame) =>
            DenoiseParameters.Default.SetGlobal(commands);
    }
}
