// Penumbra: moments of depth as integers that may be summed.
//
// Computes:   depth z in [-1/2, 1/2] and its square in steps of 2^-24 and 2^-26, each in two digits of 12 bits; and
//             their means from means of the digits. Four moments in 16 bits each; and theirs.
// Source:     positional notation: a sum of numbers is the sum of their digits, each in its place. With digits of 12
//             bits, a sum modulo 2^32 is exact over 2^20 texels; with 16, over 2^16 (Map/SummedArea.hlsl).
// Inputs:     stored shadow-map depths, either direction; means of (digit - middle).
// Cost:       no fetches.
// Guarantees: finite; errors of the mean are at most 2^-25 by the steps and 2^-24 by floats, of the mean square 2^-27
//             and 2^-25: their variance misses the true one by less than 2^-23.
// Use it:     with summed-area tables. Not: for what is filtered by the device, which interpolates no integers.
#ifndef PENUMBRA_DEPTH_DIGITS_HLSL
#define PENUMBRA_DEPTH_DIGITS_HLSL

#include "FourMoments.hlsl"

static const uint kDepthDigitMiddle = 2048;
static const uint kMomentDigitMiddle = 32768;
static const int kLargestDepthBox = 1024; // texels along a side
static const int kLargestMomentBox = 256;

uint2 TwoDigits(float number) // below 2^24
{
    const uint steps = uint(min(max(number, 0.0), 16777215.0));
    return uint2(steps >> 12, steps & 4095u);
}

uint4 DepthDigits(float storedDepth)
{
    const float depth = CentredDepth(SanitizeMapDepth(storedDepth));
    // Floats between 2^23 and 2^24 are whole numbers already, and 1/2 is added to the smaller ones.
    return uint4(TwoDigits(floor(depth * 16777216.0 + 0.5) + 8388608.0),
                 TwoDigits(floor(depth * depth * 67108864.0 + 0.5)));
}

// The mean and the mean square of depth.
float2 MomentsOfDigits(float4 centred)
{
    const float mean = (centred.x * 4096.0 + centred.y) + 2048.0;
    const float square = (centred.z * 4096.0 + centred.w) + 8390656.0; // 2048 * 4096 + 2048
    return float2(mean / 16777216.0, square / 67108864.0);
}

uint4 MomentDigits(float storedDepth)
{
    return uint4(min(max(StoredMoments(storedDepth), 0.0), 1.0) * 65535.0 + 0.5);
}

// The means of z, z^2, z^3 and z^4, of z in [-1, 1].
float4 MomentsOfMomentDigits(float4 centred)
{
    return MomentsOf((centred + 32768.0) / 65535.0);
}

#endif
