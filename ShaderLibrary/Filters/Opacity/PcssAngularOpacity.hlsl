// Penumbra: PCSS by the light's angular diameter, with the shadow of blended casters.
//
// Computes:   what PcssAngular.hlsl computes, times the share of the light that blended casters transmit, over the disc
//             of their own penumbra.
// Source:     OpacityMask.hlsl, PcssAngular.hlsl. The product takes what hides the light behind as independent of what
//             dims it.
// Inputs:     those of both.
// Cost:       that of both; of PcssAngular.hlsl alone where it gives 0.
// Guarantees: [0, 1] for any input; where the mask is empty, exactly what PcssAngular.hlsl gives; texels outside the
//             tile are not read.
// Use it:     for wires thinner than a texel, and particles. Not: where nothing is blended: tap by tap, the mask costs
//             a third of the search.
#ifndef PENUMBRA_PCSS_ANGULAR_OPACITY_HLSL
#define PENUMBRA_PCSS_ANGULAR_OPACITY_HLSL

#include "OpacityMask.hlsl"

float FilterPcssAngularOpacity(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                               TEXTURE2D(opacityMask), TEXTURE2D(blendedDepth), ShadowReceiver receiver,
                               ShadowTile tile, PcssAngularParameters parameters)
{
    const AngularSearch search = SearchAngular(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, tile, parameters);
    const float visibility = FilterFound(TEXTURE2D_ARGS(shadowMap, sampler_point), search, parameters.filterSamples);
    if (!(visibility > 0.0)) return 0.0;
    const float opacity =
        OpacityOverDisc(opacityMask, TEXTURE2D_ARGS(blendedDepth, sampler_point), search, parameters);
    return SanitizeVisibility(visibility * (1.0 - opacity));
}

#endif
