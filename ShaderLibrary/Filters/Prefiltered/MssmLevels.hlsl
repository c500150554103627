// Penumbra: moment soft shadow mapping on mip levels.
//
// Computes:   visibility of a disc light: mean blocker from four moments of the area that the farthest blocker's
//             penumbra could cover, then Hamburger's bound over the area that this blocker's penumbra covers.
// Source:     Peters, Muenstermann, Wetzstein, Klein, "Improved Moment Shadow Maps for Translucent Occluders, Soft
//             Shadows and Single Scattering", JCGT 6(1), 2017, on mip levels in place of summed-area tables:
//             Map/MapLevels.hlsl.
// Inputs:     moments: of Map/FourMoments.hlsl, with mip levels; linear sampler; ShadowReceiver; ShadowTile.
// Cost:       4 filtered fetches for each of 1 to `searches` searches; where one finds blockers, 4 more.
// Guarantees: [0, 1] for any input; nothing outside of the tile counts.
// Use it:     for wide penumbrae at a small cost, in 10.7 bytes per texel with 16 bits. Not: where three or more
//             occluders overlap in depth.
#ifndef PENUMBRA_MSSM_LEVELS_HLSL
#define PENUMBRA_MSSM_LEVELS_HLSL

#include "../../Platform/Platform.hlsl"
#include "Parameters/MssmParameters.hlsl"
#include "BoxReceiver.hlsl"
#include "../../Core/BlockerMean.hlsl"
#include "../../Core/Penumbra.hlsl"
#include "../../Map/FourMoments.hlsl"
#include "../../Map/MapLevels.hlsl"

struct MomentsAround
{
    float4 moments;
    float depth; // depth of the receiver's plane in the taps' middle, in [-1, 1]
};

MomentsAround MeanMoments(TEXTURE2D(moments), SAMPLER(sampler_moments), PlaneReceiver plane, ShadowTile tile,
                          float deviation)
{
    const LevelTaps taps = TapsOf(plane.texels, deviation, BoundsInTexels(tile));
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    float4 stored = float4(0.0, 0.0, 0.0, 0.0);
    MomentsAround around;
    around.depth = 0.0;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        stored += 0.25 * SAMPLE_TEXTURE2D_LOD(moments, sampler_moments, taps.at[i] / size, taps.level);
        around.depth += 0.5 * DepthAt(plane, taps.at[i]);
    }
    around.moments = MomentsOf(stored);
    return around;
}

float FilterMssmLevels(TEXTURE2D(moments), SAMPLER(sampler_moments), ShadowReceiver receiver, ShadowTile tile,
                       MssmParameters parameters)
{
    const PlaneReceiver plane = PlaneReceiverOf(receiver, tile);
    const ConeScales scales = ConeScalesOf(tile);
    const float floorTexels = BoundedOrLow(parameters.minFilterTexels, 0.5, 64.0);
    const float mix = BoundedOrLow(parameters.mix, 1e-7, 0.1);
    const float receiverDepth = SanitizeReceiverDepth(receiver.shadowCoord.z);
    const float search = SearchRadius(receiverDepth, parameters.maxPenumbraMetres, floorTexels, scales);

    const int searches = min(max(parameters.searches, 1), kMostSearches);
    float radius = search;
    UNITY_LOOP
    for (int i = 0; i < searches; ++i)
    {
        const MomentsAround area =
            MeanMoments(TEXTURE2D_ARGS(moments, sampler_moments), plane, tile, 0.5 * radius);
        const BlockerShare blockers = BlockersOfMoments(area.moments, area.depth, mix);
        if (!(blockers.share > kNegligibleShare)) return 1.0;
        const float searched = radius;
        const float gap = 0.5 * blockers.gapSum / blockers.share; // depths in [-1, 1] are twice as far apart
        radius = min(max(PenumbraRadius(gap, scales), floorTexels), searched);
        if (radius > kSettledShare * searched) break;
    }

    const MomentsAround box =
        MeanMoments(TEXTURE2D_ARGS(moments, sampler_moments), plane, tile, 0.5 * radius);
    const float bound = HamburgerBound(box.moments, box.depth, mix) / (1.0 - 2.0 * mix);
    return SanitizeVisibility(ReduceBleeding(bound, BoundedOrLow(parameters.bleeding, 0.0, 0.95)));
}

#endif
