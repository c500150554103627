// Penumbra: where any filter of the shadow map gives exactly 1 or exactly 0, without running it.
//
// Computes:   whether no texel that a filter may read can block the receiver, or each must, from the planes that hold the
//             blocks of the shadow map between them. What a filter reads, and when a texel blocks for it, it is told by
//             an ExitReach, which each filter has a function for.
// Source:     derived here, from Map/DepthPlanes.hlsl, as in PcssAngularDecision.hlsl.
//
//                  search      lit: no texel within the search's radius blocks (or each lies beside the cone, where the
//               |----o----|    filter has one)
//                 |--o--|      dark: the search finds a blocker for sure, and every texel within the radius that the
//                  filter      highest blocker makes does block
//
// Inputs:     ExitReach; depthPlanes: of 4 x 4 texels, with mip levels.
// Cost:       up to 9 fetches of the planes, and of filters with a search of their own up to 9 more where it is not lit.
// Guarantees: what is decided is what the filter returns, to the last bit, where its map is of 32 bits and its ExitReach
//             says the truth: the filter is 1 where no texel that it reads blocks, and 0 where each does. NaN texels
//             count as the farthest depth, which comparison samplers need not share. Tested on a software device; on an
//             NVIDIA H200 the exits of PCSS made pixels dark that are not, before both bounds became one loop
//             (Documentation~/exits.md).
// Use it:     before a filter that costs more. Not: for filtered maps, whose answers are bounds and no comparisons.
#ifndef PENUMBRA_FILTER_EXITS_HLSL
#define PENUMBRA_FILTER_EXITS_HLSL

#include "../Core/FastLoop.hlsl"
#include "ReceiverGroup.hlsl"

// As in DepthPlaneDecision.hlsl.
static const int kExitBlocksAcross = 3;
// Along one axis, the same from a bilinear footprint, with what devices round of its place.
static const float kFootprintTexels = 1.54;
// From a texel's centre to where along the plane its reference depth is taken, along each axis.
static const float kFootprintShift = 1.02;

struct ExitReach
{
    QuadReceiver receiver; // moved and biased as the filter has it; gradient 0 where it compares flat
    float planeShift;      // texels along each axis, between a texel's centre and the place of its reference on the plane
    float searchRadius;    // texels, to the centre of any texel that the filter reads before it knows a blocker
    // A texel farther away than slackTexels blocks the search only if it is nearer to the light than the receiver by
    // depthPerTexel for each texel beyond, at most by largestOffset. 0: it need not be.
    float slackTexels;
    float depthPerTexel;
    float largestOffset;
    // Of the filter that follows a search: texels of radius for each unit of gap; they grow with 1 / (1 - gap *
    // inverseDistance) where the light is thought to be at the near plane. Both 0: there is no second radius.
    float radiusPerGap;
    float inverseDistance;
    float smallestRadius;
    float largestRadius;
    float darkShare;       // of the blockers' mean gap: a texel with no more may not block the filter
    bool foundAtReceiver;  // the search begins with the texel at the receiver; else it may read any within its radius
    bool planeAlone;       // a texel above the plane may block, also if the receiver is nearer to the light
    bool insideAlone;      // what the filter does at the tile's edge is not known
    bool mayBeDark;
};

// Of a filter that reads texels within one radius, and whose rule is that of TexelQuad.hlsl.
ExitReach ReachOfDisc(QuadReceiver receiver, float radius)
{
    ExitReach reach;
    reach.receiver = receiver;
    reach.planeShift = 0.0;
    reach.searchRadius = radius;
    reach.slackTexels = 0.0;
    reach.depthPerTexel = 0.0;
    reach.largestOffset = 0.0;
    reach.radiusPerGap = 0.0;
    reach.inverseDistance = 0.0;
    reach.smallestRadius = 0.0;
    reach.largestRadius = 0.0;
    reach.darkShare = 0.0;
    reach.foundAtReceiver = false;
    reach.planeAlone = false;
    reach.insideAlone = false;
    reach.mayBeDark = true;
    return reach;
}

// The same where the receiver's plane is not used.
ExitReach FlatReachOfDisc(QuadReceiver receiver, float radius)
{
    ExitReach reach = ReachOfDisc(receiver, radius);
    reach.receiver.gradient = float2(0.0, 0.0);
    return reach;
}

// Radius of the texels that the filter reads after a search whose blockers have no larger gap.
float RadiusAfterSearch(float gap, ExitReach reach)
{
    const float before = reach.foundAtReceiver ? 0.0 : reach.searchRadius;
    if (!(reach.radiusPerGap > 0.0)) return before;
    const float left = 1.0 - gap * reach.inverseDistance;
    const float radius = left > 1e-6 ? 1.001 * gap * reach.radiusPerGap / left : reach.largestRadius;
    return max(min(max(radius, reach.smallestRadius), reach.largestRadius) + kSampleReachTexels, before);
}

// What the blocks within a radius say together.
struct ExitBounds
{
    bool whole;         // the blocks are all of the disc's
    bool noneBlocks;
    bool allBlock;
    float largestGap;   // of the texels that may block
    float smallestGap;  // of all
};

// The blocks around a receiver, and how they are bounded.
struct ExitBlocks
{
    ReceiverGroup group;
    DiscBlocks disc;
    float blockTexels;
};

ExitBlocks ExitBlocksWithin(float radius, ExitReach reach)
{
    ExitBlocks blocks;
    blocks.group = GroupOf(reach.receiver);
    const float2 rise = abs(reach.receiver.gradient);
    blocks.group.planeError = (rise.x + rise.y) * reach.planeShift;
    blocks.disc = BlocksOfDisc(reach.receiver.centre, radius, kExitBlocksAcross, reach.receiver.bounds);
    blocks.blockTexels = kRangeBlock * PowerOfTwo(blocks.disc.level);
    return blocks;
}

ExitBounds BoundsOfNoBlock(ExitBlocks blocks, ExitReach reach)
{
    ExitBounds bounds;
    bounds.whole = blocks.disc.whole;
    bounds.noneBlocks = true;
    bounds.allBlock = reach.mayBeDark;
    bounds.largestGap = 0.0;
    bounds.smallestGap = LargestGap(kFarthestDepth);
    return bounds;
}

ExitBounds AddExitBlock(ExitBounds bounds, DepthPlanes planes, int2 texel, float radius, ExitBlocks blocks, ExitReach reach)
{
    const float2 away = (float2(texel) + 0.5) * blocks.blockTexels - reach.receiver.centre;
    const GroupBounds block = BoundBlock(planes, away, blocks.blockTexels, radius, blocks.group);
    const bool beyond = block.nearest > radius;
    const float offset = min(max(block.nearest - reach.slackTexels, 0.0) * reach.depthPerTexel, reach.largestOffset);
    const bool none = beyond || (reach.planeAlone ? block.noneAbovePlane : block.noneAbove || !(block.largestGap > offset));
    const bool all = beyond || (block.allAbove && block.smallestGap > 0.0);
    ExitBounds joined = bounds;
    joined.noneBlocks = bounds.noneBlocks && none;
    joined.allBlock = bounds.allBlock && all;
    joined.largestGap = none ? bounds.largestGap : max(bounds.largestGap, block.largestGap);
    joined.smallestGap = beyond ? bounds.smallestGap : min(bounds.smallestGap, block.smallestGap);
    return joined;
}

// wantsGap: of every block, also where the disc is neither free of blockers nor full of them.
ExitBounds BoundExits(TEXTURE2D(depthPlanes), ExitReach reach, float radius, bool wantsGap)
{
    const ExitBlocks blocks = ExitBlocksWithin(radius, reach);
    ExitBounds bounds = BoundsOfNoBlock(blocks, reach);
    int2 texel = blocks.disc.low;
    PENUMBRA_LOOP
    while (HoldsBlock(texel, blocks.disc) && (bounds.noneBlocks || bounds.allBlock || wantsGap))
    {
        const DepthPlanes planes = UnpackPlanes(LOAD_TEXTURE2D_LOD(depthPlanes, texel, blocks.disc.level));
        bounds = AddExitBlock(bounds, planes, texel, radius, blocks, reach);
        texel = NextBlock(texel, blocks.disc);
    }
    return bounds;
}

bool ReachesBeyondTile(ExitReach reach, float radius)
{
    return any(reach.receiver.centre - radius < reach.receiver.bounds.minimum) ||
           any(reach.receiver.centre + radius > reach.receiver.bounds.maximum);
}

// 1, 0 or kUndecided.
float DecideExits(TEXTURE2D(depthPlanes), ExitReach reach)
{
    const bool wantsGap = reach.foundAtReceiver && reach.radiusPerGap > 0.0;
    float decided = kUndecided;
    float radius = reach.searchRadius;
    float largestGap = 0.0;
    // The texels of the search, then those of the filter that follows it. In one loop: with a second call of BoundExits behind
    // the first, a driver drew as if the second had counted one block alone (Documentation~/exits.md).
    PENUMBRA_LOOP
    for (int stage = 0; stage < 2; ++stage)
    {
        const bool isSearch = stage == 0;
        if (reach.insideAlone && ReachesBeyondTile(reach, radius)) break;
        const ExitBounds bounds = BoundExits(depthPlanes, reach, radius, isSearch && wantsGap);
        if (!bounds.whole) break;
        if (isSearch)
        {
            if (bounds.noneBlocks) decided = 1.0;
            if (bounds.noneBlocks || !reach.mayBeDark || (!reach.foundAtReceiver && !bounds.allBlock)) break;
            largestGap = bounds.largestGap;
        }
        const float filterRadius = isSearch ? RadiusAfterSearch(largestGap, reach) : radius;
        if (filterRadius == radius)
        {
            if (bounds.allBlock && bounds.smallestGap > reach.darkShare * largestGap) decided = 0.0;
            break;
        }
        radius = filterRadius;
    }
    return decided;
}

#endif
