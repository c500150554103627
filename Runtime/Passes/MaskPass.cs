using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Scripting;

namespace Penumbra
{
    /// <summary>
    /// Finds the penumbrae at a quarter of the resolution, four comparisons for each block of 4 x 4 pixels, and
    /// widens what it finds. Library: ShaderLibrary/Screen/PenumbraMask.hlsl, MaskBlur.hlsl.
    /// </summary>
    [Preserve]
    internal sealed class MaskPass : ShadowPass
    {
        internal const int Divisor = 4;
        internal const string KeywordName = "_PENUMBRA_MASK";

        internal static readonly int Texture = Shader.PropertyToID("_PenumbraMaskTexture");

        internal override int Order => 100;

        /// <summary>The resolve pass reads the mask.</summary>
        internal override string Keyword => KeywordName;

        /// <summary>A filter that costs no more than the mask gains nothing by it.</summary>
        internal override bool IsNeeded(in ShadowOptions options) =>
            options.mask && options.SamplesPenumbrae;

        internal override void AddSteps(ShadowChain chain, in ShadowOptions options)
        {
            int found = chain.Draw("PenumbraMask", Divisor);
            int wide = chain.Draw("MaskBlurHorizontal", Divisor, found);
            chain.Publish(chain.Draw("MaskBlurVertical", Divisor, wide), Texture);
        }

        /// <summary>The mask covers the penumbrae that the filter draws.</summary>
        internal override void SetUniforms(CommandBuffer commands, in ShadowFrame frame)
        {
            MaskParameters parameters = MaskParameters.Default;
            parameters.maskPenumbraMetres = frame.uniforms.PcssAngular.maxPenumbraMetres;
            parameters.SetGlobal(commands);
        }
    }
}
