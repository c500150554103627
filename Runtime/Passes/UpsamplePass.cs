using UnityEngine.Scripting;

namespace Penumbra
{
    /// <summary>Half-resolution visibility to the screen's, along edges. Library: ShaderLibrary/Screen/EdgeUpsample.hlsl.</summary>
    [Preserve]
    internal sealed class UpsamplePass : ShadowPass
    {
        internal override int Order => 300;

        internal override bool IsNeeded(in ShadowOptions options) => options.halfResolution;

        internal override void AddSteps(ShadowChain chain, in ShadowOptions options) =>
            chain.SetVisibility(chain.Draw("Upsample", 1, chain.Visibility));
    }
}
