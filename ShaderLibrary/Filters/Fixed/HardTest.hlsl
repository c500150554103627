// Penumbra: the shadow map test.
//
// Computes:   whether the texel under the receiver lies nearer to the light than the receiver: 0 or 1.
// Source:     Williams, "Casting curved shadows on curved surfaces" (1978).
// Inputs:     shadow map (raw read; the sampler is not used); ShadowReceiver; ShadowTile.
// Cost:       1 fetch.
// Guarantees: exactly 0 or 1; NaN texels do not block; no texel outside the tile is read.
// Use it:     as the baseline. Not: where shadow edges are visible.
#ifndef PENUMBRA_HARD_TEST_HLSL
#define PENUMBRA_HARD_TEST_HLSL

#include "../../Platform/Platform.hlsl"
#include "../../Core/DepthConvention.hlsl"
#include "../../Core/FloatBits.hlsl"
#include "../../Core/ShadowStructs.hlsl"
#include "../../Core/TileBounds.hlsl"

float FilterHard(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver, ShadowTile tile)
{
    const TileBounds bounds = BoundsInTexels(tile);
    const float2 texels = TexelCoordinates(receiver.shadowCoord.xy, tile);
    const int2 texel = int2(max(min(floor(texels), bounds.maximum - 1.0), bounds.minimum));
    const float mapDepth = SanitizeMapDepth(LOAD_TEXTURE2D_LOD(shadowMap, texel, 0).x);
    return IsBlocker(mapDepth, SanitizeReceiverDepth(receiver.shadowCoord.z)) ? 0.0 : 1.0;
}

#endif
