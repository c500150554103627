using UnityEngine;
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
        // The defaults of ShaderLibrary/Screen/EdgeDenoise.technique.json.
        internal const float Radius = 2.0f;
        internal const float PlaneTolerance = 2.0f;
        internal const float NoiseAmplitude = 0.25f;

        private static readonly int Params = Shader.PropertyToID("_PenumbraDenoiseParams");

        internal override int Order => 400;

        /// <summary>Tents have no noise.</summary>
        internal override bool IsNeeded(in ShadowOptions options) =>
            options.denoise && options.SamplesPenumbrae;

        internal override void AddSteps(ShadowChain chain, in ShadowOptions options)
        {
            int rows = chain.Draw("DenoiseHorizontal", 1, chain.Visibility);
            chain.SetVisibility(chain.Draw("DenoiseVertical", 1, rows));
        }

        /// <summary>Radius (pixels), distance to another surface (pixel widths), difference that is no noise.</summary>
        internal override void SetUniforms(CommandBuffer commands, in ShadowFrame frame) =>
            commands.SetGlobalVector(Params, new Vector4(Radius, PlaneTolerance, NoiseAmplitude, 0.0f));
    }
}
