// Penumbra: detection of NaN and infinity by their bits.
//
// Computes:   replacements for values that a shader must not compute with.
// Source:     IEEE 754-2019, binary32: an exponent field of all ones is infinity (fraction 0) or NaN.
// Inputs:     any float.
// Cost:       no fetches; two integer instructions per value.
// Guarantees: holds under fast mathematics, where compilers may drop floating-point tests for NaN, and on Metal,
//             whose fast clamp is undefined for it. Results are finite.
// Use it:     on every texel and parameter that comes from outside. Not: on values just computed from
//             bounded ones.
#ifndef PENUMBRA_FLOAT_BITS_HLSL
#define PENUMBRA_FLOAT_BITS_HLSL

#include "DepthConvention.hlsl"

bool HasNanBits(float value)
{
    return (asuint(value) & 0x7FFFFFFFu) > 0x7F800000u;
}

bool HasFiniteBits(float value)
{
    return (asuint(value) & 0x7F800000u) != 0x7F800000u;
}

float FiniteOr(float value, float fallback)
{
    return HasFiniteBits(value) ? value : fallback;
}

float2 FiniteOr(float2 value, float2 fallback)
{
    return float2(FiniteOr(value.x, fallback.x), FiniteOr(value.y, fallback.y));
}

// A value in [low, high]; NaN gives low, infinities the bound of their sign.
float BoundedOrLow(float value, float low, float high)
{
    return HasNanBits(value) ? low : min(max(value, low), high);
}

float3 BoundedOrLow(float3 value, float low, float high)
{
    return float3(BoundedOrLow(value.x, low, high), BoundedOrLow(value.y, low, high), BoundedOrLow(value.z, low, high));
}

// A texel of the map, clamped to a depth in [0, 1]. NaN is not a blocker, so it becomes the farthest depth.
float SanitizeMapDepth(float depth)
{
    return HasNanBits(depth) ? kFarthestDepth : min(max(depth, 0.0), 1.0);
}

float4 SanitizeMapDepth(float4 depth)
{
    return float4(SanitizeMapDepth(depth.x), SanitizeMapDepth(depth.y), SanitizeMapDepth(depth.z),
                  SanitizeMapDepth(depth.w));
}

// A receiver's depth in [0, 1]. NaN becomes the nearest depth, which nothing can block.
float SanitizeReceiverDepth(float depth)
{
    return HasNanBits(depth) ? kNearestDepth : min(max(depth, 0.0), 1.0);
}

// The last step of every filter: a visibility in [0, 1]; NaN becomes 1, fully lit.
float SanitizeVisibility(float visibility)
{
    return HasNanBits(visibility) ? 1.0 : min(max(visibility, 0.0), 1.0);
}

#endif
