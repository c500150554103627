// Penumbra: exponentials of depth.
//
// Computes:   exp(c z) of a depth z in [-1/2, 1/2]; and exp(c z), -exp(-d z) with their squares.
// Source:     Annen et al., "Exponential Shadow Maps", GI 2008; Lauritzen and McCool, "Layered Variance Shadow
//             Maps", GI 2008 (two exponentials). Centred depths: exp(c z) is at most exp(c / 2), so that c may be
//             twice as large as for depths in [0, 1].
// Inputs:     stored shadow-map depths, either direction; exponents.
// Cost:       no fetches.
// Guarantees: finite up to the largest exponents. A format whose largest number is M and whose smallest normal one is m
//             holds exp(c z) for c <= 2 min(ln M, -ln m), and its square for half of that: 32 bits 174 and 87,
//             16 bits 19.4 and 9.7. In 32 bits the sum of a blur before its division, at most 11, must fit: 172, 86.
// Use it:     for what is written into a map that is filtered. With 16 bits set exponents to at most 19 and 9.
#ifndef PENUMBRA_DEPTH_WARP_HLSL
#define PENUMBRA_DEPTH_WARP_HLSL

#include "DepthMoments.hlsl"

static const float kLargestExponent = 172.0;       // for exponentials in 32 bits
static const float kLargestSquaredExponent = 86.0; // where the square is stored, too

float ExponentialOfDepth(float storedDepth, float exponent)
{
    return exp(exponent * CentredDepth(SanitizeMapDepth(storedDepth)));
}

// x grows with depth; y is negative and grows towards 0.
float2 WarpedDepth(float centredDepth, float2 exponents)
{
    return float2(exp(exponents.x * centredDepth), -exp(-exponents.y * centredDepth));
}

// Warped depths in xy, their squares in zw.
float4 WarpedMoments(float storedDepth, float2 exponents)
{
    const float2 warped = WarpedDepth(CentredDepth(SanitizeMapDepth(storedDepth)), exponents);
    return float4(warped, warped * warped);
}

#endif
