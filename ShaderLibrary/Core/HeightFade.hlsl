// Penumbra: shadows that fade with the height of what casts them.
//
// Computes:   HeightFade: how strong the shadow of something so high over the receiver is drawn
// Source:     an artist's: a shadow without a penumbra looks wrong under what is high, and is faded out instead.
// Inputs:     height over the receiver and the height at which nothing is left, metres.
// Cost:       no fetches.
// Guarantees: [0, 1] for any input: 1 at the receiver, 0 at fadeMetres and higher; without a positive fade it is 1.
// Use it:     with planar and blob shadows. Not: where the shadow has a penumbra of its own.
#ifndef PENUMBRA_HEIGHT_FADE_HLSL
#define PENUMBRA_HEIGHT_FADE_HLSL

#include "FloatBits.hlsl"

float HeightFade(float height, float fadeMetres)
{
    if (!(fadeMetres > 0.0)) return 1.0;
    return 1.0 - BoundedOrLow(BoundedOrLow(height, 0.0, 1e30) / fadeMetres, 0.0, 1.0);
}

#endif
