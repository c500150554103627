// Penumbra: the single loop, with the shadow of blended casters.
//
// Computes:   what SingleLoop.hlsl computes, times the share of the light that the mask at the receiver transmits.
// Source:     Candycat, "Graphics Study: RDR2, shadows" (2021), which has one sample of a mask of 8 bits, without
//             depth.
// Inputs:     those of SingleLoop.hlsl and OpacityMask.hlsl; the linear sampler.
// Cost:       1 fetch more than SingleLoop.hlsl.
// Guarantees: [0, 1] for any input; where the mask is empty, exactly what SingleLoop.hlsl gives; texels outside the
//             tile are not read.
// Use it:     where blended casters are near to what they shade, and nothing stands above them. Not:
//             elsewhere, since receivers above them are dimmed as well, and edges are as sharp as texels, however high
//             the casters are.
#ifndef PENUMBRA_SINGLE_LOOP_OPACITY_HLSL
#define PENUMBRA_SINGLE_LOOP_OPACITY_HLSL

#include "OpacityMask.hlsl"
#include "../SingleLoop/SingleLoop.hlsl"

float FilterSingleLoopOpacity(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                              TEXTURE2D_PARAM(opacityMask, sampler_linear), ShadowReceiver receiver, ShadowTile tile,
                              SingleLoopParameters parameters)
{
    const float visibility = RunSingleLoop(shadowMap, PrepareSingleLoop(receiver, tile, parameters));
    const float opacity = OpacityAtReceiver(TEXTURE2D_ARGS(opacityMask, sampler_linear), receiver, tile);
    return SanitizeVisibility(visibility * (1.0 - opacity));
}

#endif
