// Penumbra: dilation of the mask of shadow edges to a mask of penumbrae.
//
// Computes:   how far a penumbra can reach from its edge at a receiver, in texels of the mask, and whether an edge lies
//             within that reach: a maximum along one direction, so that two calls widen a square.
// Source:     the widest penumbra is that of a blocker at the map's near plane (Core/Penumbra.hlsl), or what the
//             technique caps it to. A pixel covers fewer metres the nearer it is, so the radius grows towards the
//             camera.
// Inputs:     MaskParameters; stored depth of the receiver and its tile; mask texture, 1 at edges.
// Cost:       2 radius + 1 fetches per texel of the mask, fewer where an edge is found early.
// Guarantees: exactly 0 or 1. Reads no texel outside the mask; NaN in it counts as an edge. The reach is
//             measured across the light, so at grazing light a penumbra on the surface may extend beyond it.
// Use it:     horizontally, then vertically. Not: with a mean instead of the maximum, which at 8 bits can
//             round a single edge to 0.
#ifndef PENUMBRA_MASK_BLUR_HLSL
#define PENUMBRA_MASK_BLUR_HLSL

#include "../Platform/Platform.hlsl"
#include "../Core/Penumbra.hlsl"
#include "Parameters/MaskParameters.hlsl"
#include "PenumbraMask.hlsl"

// Metres across the light from an edge to the end of its penumbra.
float MaskReachMetres(float receiverDepth, ShadowTile tile, MaskParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const float depth = SanitizeReceiverDepth(receiverDepth);
    const float texels = SearchRadius(depth, parameters.maskPenumbraMetres, parameters.maskFilterTexels, scales);
    return texels / max(scales.texelsPerMetre, 1e-9);
}

int MaskRadius(float reachMetres, float metresPerPixel, MaskParameters parameters)
{
    const float texels = reachMetres / max(metresPerPixel * float(kMaskBlock), 1e-9);
    return int(ceil(BoundedOrLow(texels, 0.0, float(max(parameters.maskLargestRadius, 0)))));
}

bool IsMasked(TEXTURE2D_X(mask), int2 texel, int2 size)
{
    if (any(texel < 0) || any(texel >= size)) return false;
    const float value = LOAD_TEXTURE2D_X(mask, texel).x;
    return HasNanBits(value) || value >= 0.5;
}

// direction is (1, 0) or (0, 1).
float WidenMask(TEXTURE2D_X(mask), int2 texel, int2 direction, int radius, int2 size)
{
    if (IsMasked(mask, texel, size)) return 1.0;
    UNITY_LOOP
    for (int i = 1; i <= radius; ++i)
    {
        if (IsMasked(mask, texel - i * direction, size) || IsMasked(mask, texel + i * direction, size)) return 1.0;
    }
    return 0.0;
}

#endif
