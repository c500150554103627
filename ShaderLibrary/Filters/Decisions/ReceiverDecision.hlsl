// Penumbra: where PCSS by angular diameter is exactly 1 or exactly 0 for one receiver, and else how wide its penumbra
// can be.
//
// Computes:   whether the planes that hold the blocks of the shadow map show that no texel around the receiver blocks
//             it, or that each does; where they do not, a radius that no blocker's penumbra exceeds.
// Source:     derived here, from Map/DepthPlanes.hlsl, as in GroupDecision.hlsl.
// Inputs:     those of PcssAngular.hlsl, whose numbers of samples are not used; depthPlanes of blocks of 4 x 4 texels,
//             coarsePlanes of 8 x 8 texels, with mip levels.
// Cost:       up to 9 fetches of the planes for each of up to kMostRingRadii radii.
// Guarantees: what is decided is what FilterPcssAngular returns, to the last bit, in tests on a software device. NaN
//             texels count as the farthest depth, which comparison samplers need not share.
// Use it:     before CellFilter.hlsl's sums.
#ifndef PENUMBRA_RECEIVER_DECISION_HLSL
#define PENUMBRA_RECEIVER_DECISION_HLSL

#include "../../Core/FastLoop.hlsl"
#include "../Pcss/PcssAngular.hlsl"
#include "ReceiverGroup.hlsl"

// Each radius is that of the blockers which the blocks within the radius before allow. Two scenes under a light of 2
// degrees take 57, 47, 47 and 47 fetches per pixel with 1, 2, 3 and 4 radii, without the passes over the map; under 5
// degrees they take 103, 100, 95 and 95.
static const int kMostRingRadii = 3;
// A radius that shrinks to more than this share of the one before is not tried again.
static const float kRingRadiusShrinks = 0.75;
static const float kSmallestRingRadius = 2.0;

// A disc takes as many blocks each way as in DiscDecision.hlsl.
static const int kRingBlocksAcross = 3;

struct RingReach
{
    QuadReceiver receiver;
    LightCone cone;
    float smallestRadius; // smallest radius of the filter, texels
    float largestRadius;  // largest radius of the search, texels
};

struct RingDecision
{
    float visibility; // visibility, or kUndecided
    float radius;     // texels: no blocker's penumbra is wider
};

// These bounds hold for all blocks within a radius together.
struct RingBounds
{
    bool whole;         // the blocks are all of the disc's
    bool noneBlocks;
    bool allBlock;
    float largestGap;   // largest gap of the texels that may block
    float smallestGap;  // smallest gap of all texels
};

RingReach RingReachOf(ShadowReceiver receiver, ShadowTile tile, PcssAngularParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const float smallest = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    RingReach reach;
    reach.receiver = PrepareQuads(receiver, tile);
    reach.cone.scales = scales;
    reach.cone.slackTexels = smallest + kWidestSlackTexels;
    reach.cone.largestOffset = BoundedOrLow(parameters.maxSamplingMetres, 0.0, 1e6) * scales.depthPerMetre;
    reach.smallestRadius = max(smallest, kWidestBlockTexels);
    reach.largestRadius = max(SearchRadius(reach.receiver.depth, parameters.maxPenumbraMetres, smallest, scales),
                              reach.smallestRadius);
    return reach;
}

// The planes are of a block of the level, whose first level is a texture of its own.
DepthPlanes PlanesOfLevel(TEXTURE2D(depthPlanes), TEXTURE2D(coarsePlanes), int2 block, int level)
{
    float4 planes;
    UNITY_BRANCH
    if (level == 0) planes = LOAD_TEXTURE2D(depthPlanes, block);
    else planes = LOAD_TEXTURE2D_LOD(coarsePlanes, block, level - 1);
    return UnpackPlanes(planes);
}

RingBounds AddRingBlock(RingBounds bounds, DepthPlanes planes, int2 texel, float radius, DiscBlocks disc,
                        RingReach reach)
{
    const float blockTexels = kRangeBlock * PowerOfTwo(disc.level);
    const float2 away = (float2(texel) + 0.5) * blockTexels - reach.receiver.centre;
    const GroupBounds block = BoundBlock(planes, away, blockTexels, radius, GroupOf(reach.receiver));
    const bool beyond = block.nearest > radius;
    const float offset = ConeOffset(block.nearest, reach.cone.slackTexels, reach.cone.largestOffset, reach.cone.scales);
    const bool none = beyond || block.noneAbove || !(block.largestGap > offset);
    const bool all = beyond || (block.allAbove && block.smallestGap > 0.0);
    RingBounds joined = bounds;
    joined.noneBlocks = bounds.noneBlocks && none;
    joined.allBlock = bounds.allBlock && all;
    joined.largestGap = none ? bounds.largestGap : max(bounds.largestGap, block.largestGap);
    joined.smallestGap = beyond ? bounds.smallestGap : min(bounds.smallestGap, block.smallestGap);
    return joined;
}

RingBounds BoundRings(TEXTURE2D(depthPlanes), TEXTURE2D(coarsePlanes), RingReach reach, float radius)
{
    const DiscBlocks disc = BlocksOfDisc(reach.receiver.centre, radius, kRingBlocksAcross, reach.receiver.bounds);
    RingBounds bounds;
    bounds.whole = disc.whole;
    bounds.noneBlocks = true;
    bounds.allBlock = true;
    bounds.largestGap = 0.0;
    bounds.smallestGap = LargestGap(kFarthestDepth);
    int2 texel = disc.low;
    PENUMBRA_LOOP
    while (HoldsBlock(texel, disc))
    {
        const DepthPlanes planes = PlanesOfLevel(depthPlanes, coarsePlanes, texel, disc.level);
        bounds = AddRingBlock(bounds, planes, texel, radius, disc, reach);
        texel = NextBlock(texel, disc);
    }
    return bounds;
}

RingDecision DecideRings(TEXTURE2D(depthPlanes), TEXTURE2D(coarsePlanes), RingReach reach)
{
    const float darkShare = kRoundedShare * kConeHeightShare;
    RingDecision decision;
    decision.visibility = kUndecided;
    const float narrowest = max(reach.smallestRadius, kSmallestRingRadius);
    decision.radius = max(reach.largestRadius, narrowest);
    PENUMBRA_LOOP
    for (int i = 0; i < kMostRingRadii; ++i)
    {
        const RingBounds bounds = BoundRings(depthPlanes, coarsePlanes, reach, decision.radius + kSampleReachTexels);
        if (!bounds.whole) break;
        if (bounds.noneBlocks) decision.visibility = 1.0;
        else if (bounds.allBlock && bounds.smallestGap > darkShare * bounds.largestGap) decision.visibility = 0.0;
        if (decision.visibility >= 0.0) break;
        const float before = decision.radius;
        decision.radius = max(min(PenumbraRadius(bounds.largestGap, reach.cone.scales), before), narrowest);
        if (decision.radius > kRingRadiusShrinks * before) break;
    }
    return decision;
}

#endif
