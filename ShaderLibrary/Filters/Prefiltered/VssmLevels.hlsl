// Penumbra: variance soft shadow mapping on mip levels.
//
// Computes:   visibility of a disc light: mean blocker from two moments of the area that the farthest blocker's
//             penumbra could cover, then Chebyshev's bound over the area that this blocker's penumbra covers.
// Source:     Yang, Dong, Feng, Seidel, Kautz, "Variance Soft Shadow Mapping", Pacific Graphics 2010. Widths are those
//             of Core/Penumbra.hlsl; means are those of Map/MapLevels.hlsl.
// Inputs:     moments: two of depth, in numbers between 0 and 1, with mip levels; linear sampler; ShadowReceiver;
//             ShadowTile.
// Cost:       4 filtered fetches for each of 1 to `searches` searches; where one finds blockers, 4 more.
// Guarantees: [0, 1] for any input; nothing outside of the tile counts.
// Use it:     for wide penumbrae at a small cost, in 5.3 bytes per texel with 16 bits. Not: where occluders overlap in
//             depth, as foliage does: light leaks between them.
#ifndef PENUMBRA_VSSM_LEVELS_HLSL
#define PENUMBRA_VSSM_LEVELS_HLSL

#include "../../Platform/Platform.hlsl"
#include "Parameters/VssmParameters.hlsl"
#include "BoxReceiver.hlsl"
#include "../../Core/BlockerMean.hlsl"
#include "../../Core/Penumbra.hlsl"
#include "../../Map/MapLevels.hlsl"

struct VarianceTaps
{
    BlockerShare blockers;
    float visibility;
};

float2 LevelMoments(TEXTURE2D(moments), SAMPLER(sampler_moments), float2 texels, float level, ShadowTile tile)
{
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    return DepthMomentsOf(SAMPLE_TEXTURE2D_LOD(moments, sampler_moments, texels / size, level).xy);
}

// The bound of the four taps' mean where that mean lies before the receiver. Elsewhere each tap is bounded by itself,
// and taps whose mean lies behind count as lit.
VarianceTaps VarianceAround(TEXTURE2D(moments), SAMPLER(sampler_moments), PlaneReceiver plane, ShadowTile tile,
                            float deviation, float smallest)
{
    const LevelTaps taps = TapsOf(plane.texels, deviation, BoundsInTexels(tile));
    const float2 squaredSlope = plane.slope * plane.slope;
    const float own = 0.25 * exp2(2.0 * taps.level);
    const float least = smallest + 0.25 * (squaredSlope.x + squaredSlope.y);
    float2 mean = float2(0.0, 0.0);
    float depth = 0.0;
    VarianceTaps each;
    each.blockers.share = 0.0;
    each.blockers.gapSum = 0.0;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        float2 tap = LevelMoments(TEXTURE2D_ARGS(moments, sampler_moments), taps.at[i], taps.level, tile);
        const float tapDepth = DepthAt(plane, taps.at[i]);
        mean += 0.25 * tap;
        depth += 0.25 * tapDepth;
        tap.y -= (squaredSlope.x + squaredSlope.y) * max(own - 0.25, 0.0);
        const BlockerShare blockers = BlockersOfVariance(tap, tapDepth, least);
        each.blockers.share += 0.25 * blockers.share;
        each.blockers.gapSum += 0.25 * blockers.gapSum;
    }
    mean.y -= (squaredSlope.x + squaredSlope.y) * max(deviation * deviation - 0.25, 0.0);
    if (depth > mean.x) each.blockers = BlockersOfVariance(mean, depth, least);
    each.visibility = 1.0 - each.blockers.share;
    return each;
}

float FilterVssmLevels(TEXTURE2D(moments), SAMPLER(sampler_moments), ShadowReceiver receiver, ShadowTile tile,
                       VssmParameters parameters)
{
    const PlaneReceiver plane = PlaneReceiverOf(receiver, tile);
    const ConeScales scales = ConeScalesOf(tile);
    const float floorTexels = BoundedOrLow(parameters.minFilterTexels, 0.5, 64.0);
    const float smallest = BoundedOrLow(parameters.smallestVariance, 1e-7, 1e-2);
    const float receiverDepth = SanitizeReceiverDepth(receiver.shadowCoord.z);
    const float search = SearchRadius(receiverDepth, parameters.maxPenumbraMetres, floorTexels, scales);

    const int searches = min(max(parameters.searches, 1), kMostSearches);
    float radius = search;
    UNITY_LOOP
    for (int i = 0; i < searches; ++i)
    {
        const BlockerShare blockers =
            VarianceAround(TEXTURE2D_ARGS(moments, sampler_moments), plane, tile, 0.5 * radius, smallest).blockers;
        if (!(blockers.share > kNegligibleShare)) return 1.0;
        const float searched = radius;
        radius = min(max(PenumbraRadius(blockers.gapSum / blockers.share, scales), floorTexels), searched);
        if (radius > kSettledShare * searched) break;
    }

    const float bound =
        VarianceAround(TEXTURE2D_ARGS(moments, sampler_moments), plane, tile, 0.5 * radius, smallest).visibility;
    return SanitizeVisibility(ReduceBleeding(bound, BoundedOrLow(parameters.bleeding, 0.0, 0.95)));
}

#endif
