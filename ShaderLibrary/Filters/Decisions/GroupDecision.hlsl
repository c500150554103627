// Penumbra: where PCSS by angular diameter is exactly 1 or exactly 0, for a group of receivers, without running it.
//
// Computes:   whether PcssAngular.hlsl gives 1 at every receiver of a group, or 0 at every one, from the planes that
//             hold the blocks of the shadow map between them.
// Source:     derived here, from Map/DepthPlanes.hlsl.
//
//                 \  light's cone  /       a block whose depths all lie below the receivers' planes, behind them, or
//              [a] \              /        beside their cones (a) blocks none; where every block in reach is such a
//                   \    [b]     /         one, they are lit. Where every block in reach (b) lies above all of them, by
//                    \  /---\   /          more than the share of its height to which the filter's cone is cut, they
//                     \/_____\_/           are dark
//
// Inputs:     depthPlanes: of 4 x 4 texels, with mip levels; ReceiverGroup; scales of its tile; PcssAngularParameters.
// Cost:       a fetch for each block that it looks at: up to 4 x 4 large ones, and parts of those that it cannot decide
//             as a whole. After kMostBlocks it divides no more. In all three searches 5 to 120 on average over scenes
//             and lights from 0.53 to 5 degrees, about 550 at most.
// Guarantees: what is decided is what FilterPcssAngular returns, to the last bit, for every receiver of the group, any
//             rotation and any number of samples, in tests on a software device.
// Use it:     for a mask of whole tiles of pixels, Shaders/ConservativeMaskPass.hlsl. Not: for PcssClassic.hlsl and
//             PcssHdrp.hlsl, whose cones differ.
#ifndef PENUMBRA_GROUP_DECISION_HLSL
#define PENUMBRA_GROUP_DECISION_HLSL

#include "../Pcss/PcssAngular.hlsl"
#include "ReceiverGroup.hlsl"

static const int kGroupBlocksAcross = 4;
// With 64, 128, 256 and 1000 blocks the mask decides 16.6, 22.1, 25.4 and 27.6 % of the pixels under a disc of 5
// degrees, for 6.2, 6.9, 7.6 and 10.5 fetches per pixel; under the sun's disc it decides 54.6, 55.7, 55.9 and 55.9 %,
// always for 5.1 fetches (mean of three scenes).
static const int kMostBlocks = 256;

// A search over the blocks around a group, from few large ones down to the parts of those that are not decided as a
// whole.
struct BlockWalk
{
    DiscBlocks top;
    int2 texel;
    int level;
    int visited;
    float reach; // distance from a receiver to the texels that it reads
};

BlockWalk WalkAround(ReceiverGroup group, float radius)
{
    BlockWalk walk;
    walk.reach = radius + kSampleReachTexels;
    walk.top = BlocksOfDisc(group.first.centre, walk.reach + group.spread, kGroupBlocksAcross, group.first.bounds);
    walk.texel = walk.top.low;
    walk.level = walk.top.level;
    walk.visited = 0;
    return walk;
}

GroupBounds ReadBlock(TEXTURE2D(depthPlanes), BlockWalk walk, ReceiverGroup group)
{
    const float blockTexels = kRangeBlock * PowerOfTwo(walk.level);
    const float2 away = (float2(walk.texel) + 0.5) * blockTexels - group.first.centre;
    const DepthPlanes planes = UnpackPlanes(LOAD_TEXTURE2D_LOD(depthPlanes, walk.texel, walk.level));
    return BoundBlock(planes, away, blockTexels, walk.reach, group);
}

// The first of the block's four parts.
BlockWalk IntoBlock(BlockWalk walk)
{
    BlockWalk next = walk;
    next.texel = 2 * walk.texel;
    next.level = walk.level - 1;
    next.visited = walk.visited + 1;
    return next;
}

// The block after this one and its parts.
BlockWalk PastBlock(BlockWalk walk)
{
    BlockWalk next = walk;
    next.visited = walk.visited + 1;
    while (next.level < next.top.level && (next.texel.x & next.texel.y & 1) != 0)
    {
        next.texel = next.texel >> 1;
        next.level += 1;
    }
    const bool isTop = next.level == next.top.level;
    const bool endsRow = isTop ? next.texel.x == next.top.high.x : (next.texel.x & 1) != 0;
    const int rowBegin = isTop ? next.top.low.x : next.texel.x - 1;
    next.texel = endsRow ? int2(rowBegin, next.texel.y + 1) : int2(next.texel.x + 1, next.texel.y);
    return next;
}

bool HasBlocks(BlockWalk walk)
{
    return walk.level < walk.top.level || walk.texel.y <= walk.top.high.y;
}

// An upper bound of the gaps of all texels that can block a receiver of the group; 0 where none can. finest is the
// level of the smallest blocks that are read.
float LargestBlockingGap(TEXTURE2D(depthPlanes), ReceiverGroup group, LightCone cone, float radius, int finest)
{
    BlockWalk walk = WalkAround(group, radius);
    float largest = walk.top.whole ? 0.0 : kAnyGap;
    UNITY_LOOP
    while (walk.top.whole && HasBlocks(walk))
    {
        const GroupBounds block = ReadBlock(depthPlanes, walk, group);
        const float offset = ConeOffset(block.nearest, cone.slackTexels, cone.largestOffset, cone.scales);
        const bool mayBlock = !block.noneAbove && block.nearest <= walk.reach && block.largestGap > offset;
        if (mayBlock && walk.level > finest)
        {
            walk = IntoBlock(walk);
            if (walk.visited < kMostBlocks) continue;
        }
        if (mayBlock) largest = max(largest, block.largestGap);
        if (mayBlock && finest == 0) break;
        walk = PastBlock(walk);
    }
    return largest;
}

// Whether every texel within the radius blocks every receiver, from a gap of `smallestGap` up.
bool AllBlock(TEXTURE2D(depthPlanes), ReceiverGroup group, float radius, float smallestGap)
{
    BlockWalk walk = WalkAround(group, radius);
    bool all = walk.top.whole;
    UNITY_LOOP
    while (all && HasBlocks(walk))
    {
        const GroupBounds block = ReadBlock(depthPlanes, walk, group);
        const bool blocks = block.nearest > walk.reach || (block.allAbove && block.smallestGap > smallestGap);
        if (!blocks && walk.level > 0 && walk.visited < kMostBlocks)
        {
            walk = IntoBlock(walk);
            continue;
        }
        all = blocks;
        walk = PastBlock(walk);
    }
    return all;
}

// The visibility of every receiver of the group, or kUndecided. mayBeDark is false where other receivers are known to
// be lit.
float DecideAngular(TEXTURE2D(depthPlanes), ReceiverGroup group, ConeScales scales, PcssAngularParameters parameters,
                    bool mayBeDark)
{
    const float smallestRadius = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    LightCone cone;
    cone.scales = scales;
    cone.slackTexels = smallestRadius + kWidestSlackTexels;
    cone.largestOffset = BoundedOrLow(parameters.maxSamplingMetres, 0.0, 1e6) * scales.depthPerMetre;
    const float narrowest = max(smallestRadius, kWidestBlockTexels);
    const float search = max(SearchRadius(group.depths.y, parameters.maxPenumbraMetres, smallestRadius, scales),
                             narrowest);
    const bool perhapsDark = mayBeDark && AllBlock(depthPlanes, group, 0.0, 0.0);
    const float gap = LargestBlockingGap(depthPlanes, group, cone, search, perhapsDark ? 16 : 0);
    if (!(gap > 0.0)) return 1.0;
    if (!perhapsDark) return kUndecided;
    // The search's mean is no larger than this gap, and the filter's disc no wider than what it makes.
    const float radius = min(max(PenumbraRadius(gap, scales), narrowest), search);
    const bool dark = AllBlock(depthPlanes, group, radius, kRoundedShare * kConeHeightShare * gap);
    return dark ? 0.0 : kUndecided;
}

#endif
