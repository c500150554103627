// Penumbra: depths of the shadow map as numbers that may be filtered.
//
// Computes:   depth from the light, centred in the map's range, and its square.
// Source:     Donnelly and Lauritzen, "Variance Shadow Maps", I3D 2006. Centred depths: the rounding error of a
//             variance is a share of the mean square, which is at most 1/4 and not 1 of depths in [-1/2, 1/2].
// Inputs:     stored shadow-map depths, either direction.
// Cost:       no fetches.
// Guarantees: finite; -1/2 nearest the light, 1/2 farthest; NaN is farthest, as everywhere in the library.
// Use it:     for what is written into a filtered map, and for the receiver that is compared with it.
#ifndef PENUMBRA_DEPTH_MOMENTS_HLSL
#define PENUMBRA_DEPTH_MOMENTS_HLSL

#include "../Core/DepthConvention.hlsl"
#include "../Core/FloatBits.hlsl"

// Two blurs, their sums and one bilinear fetch round the mean square, and the mean that is squared.
static const float kRoundings = 16.0;

float CentredDepth(float storedDepth)
{
    return DepthGap(kNearestDepth, storedDepth) - 0.5;
}

float2 DepthMoments(float storedDepth)
{
    const float depth = CentredDepth(SanitizeMapDepth(storedDepth));
    return float2(depth, depth * depth);
}

// The moments between 0 and 1, as integer formats hold them; DepthMomentsOf takes them back.
float2 StoredDepthMoments(float storedDepth)
{
    const float2 moments = DepthMoments(storedDepth);
    return float2(0.5 + moments.x, 4.0 * moments.y);
}

float2 DepthMomentsOf(float2 stored)
{
    return float2(stored.x - 0.5, 0.25 * stored.y);
}

#endif
