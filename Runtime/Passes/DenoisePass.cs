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
            options.denoise && options.technique.TakesSamples() && options.angularDiameterDegrees > 0.0f;

        internal override void AddSteps(ShadowChain chain, in ShadowOptions options)
        {
            int divisor = chain.DivisorOf(chain.Visibility);
            int rows = chain.Draw("DenoiseHorizontal", divisor, chain.Visibility);
            chain.SetVisibility(chain.Draw("DenoiseVertical", divisor, rows));
        }
    }
}
