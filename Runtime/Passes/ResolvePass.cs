using UnityEngine.Scripting;

namespace Penumbra
{
    /// <summary>The technique itself, at every pixel or at every second one along both axes.</summary>
    [Preserve]
    internal sealed class ResolvePass : ShadowPass
    {
        internal override int Order => 200;

        internal override bool IsNeeded(in ShadowOptions options) => true;

        internal override void AddSteps(ShadowChain chain, in ShadowOptions options) =>
            chain.SetVisibility(chain.Draw("Resolve", options.halfResolution ? 2 : 1));
    }
}
