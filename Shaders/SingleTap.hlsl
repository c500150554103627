// Penumbra: one comparison of the main light's shadow map, for pixels outside penumbrae.
//
// Computes:   the share of the four nearest texels, by bilinear weight, that do not block the receiver.
// Source:     Filters/Fixed/FixedPcf.hlsl; Filters/Taps/TexelQuad.hlsl beside a filter that reads raw depths, because a
//             comparison texture must not be read raw in the same program.
// Inputs:     PenumbraMainLight.
// Cost:       1 fetch.
// Guarantees: [0, 1]; 1 where no map covers the receiver. The shadow strength is not applied.
// Use it:     after Shadows.hlsl.
#ifndef PENUMBRA_SINGLE_TAP_HLSL
#define PENUMBRA_SINGLE_TAP_HLSL

#include "../ShaderLibrary/Shadows.hlsl"

#if defined(PENUMBRA_READS_RAW_DEPTH)
#include "../ShaderLibrary/Filters/Taps/TexelQuad.hlsl"
#else
#include "../ShaderLibrary/Filters/Fixed/FixedPcf.hlsl"
#endif

float SingleTap(PenumbraMainLight shadow)
{
    if (!shadow.covered) return 1.0;
#if defined(PENUMBRA_READS_RAW_DEPTH)
    const QuadReceiver receiver = PrepareQuads(shadow.receiver, shadow.tile);
    LightCone disc;
    disc.scales = ConeScalesOf(shadow.tile);
    disc.slackTexels = 0.0;
    disc.largestOffset = 0.0;
    const TexelQuad quad =
        ReadQuad(TEXTURE2D_ARGS(_MainLightShadowmapTexture, sampler_PenumbraPointClamp), receiver, disc,
                 receiver.centre);
    return LitShare(dot(quad.weight, 1.0 - quad.blocking), dot(quad.weight, quad.blocking));
#else
    return FilterBilinear(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_PenumbraLinearClampCompare),
                          shadow.receiver, shadow.tile);
#endif
}

#endif
