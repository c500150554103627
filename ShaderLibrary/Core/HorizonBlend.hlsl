// Penumbra: how much of a sun is above a horizon that is known in eight directions of the compass.
//
// Computes:   HorizonWeightsOf   weights of the two neighbouring directions for a sun between them
//             BlendedHorizon     the horizon's angle of elevation in the sun's direction
//             HorizonVisibility  the share of the sun's disc above it
// Source:     Max, "Horizon mapping: shadows for bump-mapped surfaces" (1988): horizons are tabulated by azimuth and
//             interpolated linearly. Candycat, "Graphics Study: RDR2, shadows" (2021): eight directions in two textures
//             of four channels, compared with the sun's pitch. There the two halves' sums are combined by max, which of
//             two neighbours in different textures takes the larger share alone; here they are added, since the weights
//             of all eight are those of one interpolation.
// Inputs:     the direction towards the sun, horizontal: x and z, of any positive length; angles in radians.
// Cost:       no fetches. The weights and the angle of the sun are the same for every pixel.
// Guarantees: weights are >= 0, at most two of them are not 0, their sum is within 1 ULP of 1; a direction without
//             length is that of +Z. Visibility as of DiscHorizon.hlsl; without a diameter it is 0 or 1.
// Use it:     for a sun over ground that does not change. Not: near what casts the shadow, where eight directions are
//             few.
#ifndef PENUMBRA_HORIZON_BLEND_HLSL
#define PENUMBRA_HORIZON_BLEND_HLSL

#include "DiscHorizon.hlsl"

// Weights of directions 0 to 3, and 4 to 7. Direction 0 is +Z and direction 2 is +X: 45 degrees lie from one to the
// next.
struct HorizonWeights
{
    float4 first;
    float4 second;
};

HorizonWeights HorizonWeightsOf(float2 towardSun)
{
    const float x = FiniteOr(towardSun.x, 0.0);
    const float z = FiniteOr(towardSun.y, 0.0);
    const bool level = x != 0.0 || z != 0.0;
    const float eighths = (level ? atan2(x, z) : 0.0) * (4.0 / 3.14159265358979);  // in [-4, 4]
    const float below = floor(eighths);
    const float share = eighths - below;
    const int lower = (int(below) + 8) & 7;
    const int upper = (lower + 1) & 7;
    HorizonWeights weights;
    const float4 numbers = float4(0.0, 1.0, 2.0, 3.0);
    const float4 low = float4(lower.xxxx);
    const float4 high = float4(upper.xxxx);
    weights.first = (numbers == low) * (1.0 - share) + (numbers == high) * share;
    weights.second = (numbers + 4.0 == low) * (1.0 - share) + (numbers + 4.0 == high) * share;
    return weights;
}

float BlendedHorizon(float4 anglesFirst, float4 anglesSecond, HorizonWeights weights)
{
    return dot(anglesFirst, weights.first) + dot(anglesSecond, weights.second);
}

// elevation: of the sun's centre. halfDiameter: half its angular diameter, or more for a softer edge.
float HorizonVisibility(float horizon, float elevation, float halfDiameter)
{
    if (!(halfDiameter > 0.0)) return horizon < elevation ? 1.0 : 0.0;
    return DiscShareAbove((horizon - elevation) / halfDiameter);
}

#endif
