// Penumbra: which pixels are lit or dark, decided for parts of 4 x 4 pixels at once.
//
// Computes:   clusters of a tile's parts, near each other in one cascade, which read the same blocks of the shadow map;
//             and for the receivers of each part whether PCSS by angular diameter gives 1 at all of them, 0 at all of
//             them, or may give anything.
// Source:     the decision of GroupDecision.hlsl, over blocks in groupshared memory instead of a search.
// Inputs:     PartReceivers of each thread; depthPlanes, of 4 x 4 texels, and coarsePlanes, of 8 x 8, with mip levels;
//             PcssAngularParameters.
// Cost:       for each of up to TILE_CLUSTERS clusters of a tile of 16 x 16 pixels up to 16 fetches for the first
//             radius and 64 for each of up to 3 more, each of which is what the blocks of the one before allow: a
//             quarter of a fetch per pixel for 64. Each block that a part can reach is tested once for its 16 pixels.
// Guarantees: those of GroupDecision.hlsl. All threads of the group call the functions with barriers, in the same
//             order.
// Use it:     in kernels of 8 x 8 threads, one for each part of 2 x 2 tiles.
#ifndef PENUMBRA_TILE_CLUSTERS_HLSL
#define PENUMBRA_TILE_CLUSTERS_HLSL

#include "TileSurfaces.hlsl"
#include "../Filters/Decisions/GroupDecision.hlsl"

#define TILE_PIXELS 16
#define PART_PIXELS 4
// A tile has so many parts, which 16 threads decide.
#define TILE_PARTS 16
// A part has so many pixels.
#define PART_LANES 16
// A group decides so many tiles, in a square.
#define GROUP_TILES 4
#define GROUP_TILES_ACROSS 2
#define GROUP_THREADS 64
// Pixels that are left after so many clusters remain undecided.
#define TILE_CLUSTERS 4
#define MOST_BLOCKS_ACROSS 8
#define MOST_RADII 4

// A part's first receiver lies at most so far from that of its cluster, texels along each axis. A receiver lies at most
// so far from the plane of its part's first, in texels of its cascade along the light.
static const float kClusterTexels = 24.0;
static const float kPartDepthTexels = 4.0;
static const int kFirstBlocksAcross = 4;
// A radius that shrinks to more than this share of the one before is not tried again.
static const float kShrinks = 0.75;
static const float kSmallestClusterRadius = 2.0;
static const float kWidestHalf = 65504.0;

// The receivers of a part's pixels in one cascade, near one plane.
struct PartReceivers
{
    bool any;
    uint pixels; // a bit for each of the part's pixels, row by row
    uint cascade;
    ReceiverGroup group;
    float2 low;  // texels
    float2 high;
};

// The decision on a part's receivers. No blocker's penumbra exceeds radius, texels, where visibility is kUndecided.
struct PartDecision
{
    float visibility;
    float radius;
};

// Each cluster of each tile has one of these.
groupshared uint clusterFirst[GROUP_TILES * TILE_CLUSTERS];
groupshared float2 clusterCentre[GROUP_TILES * TILE_CLUSTERS];
groupshared uint clusterCascade[GROUP_TILES * TILE_CLUSTERS];
groupshared int clusterLeft[GROUP_TILES * TILE_CLUSTERS];
groupshared int clusterTop[GROUP_TILES * TILE_CLUSTERS];
groupshared int clusterRight[GROUP_TILES * TILE_CLUSTERS];
groupshared int clusterBottom[GROUP_TILES * TILE_CLUSTERS];
groupshared uint clusterRadius[GROUP_TILES * TILE_CLUSTERS * (MOST_RADII + 1)];
groupshared float4 clusterBlocks[GROUP_TILES * MOST_BLOCKS_ACROSS * MOST_BLOCKS_ACROSS];

struct PartThread
{
    uint index;
    uint tile; // number of the tile in the group
    uint part; // number of the part in the tile
    int2 firstPixel; // place in the group's square
};

PartThread PartThreadAt(uint2 place)
{
    const uint2 parts = TILE_PIXELS / PART_PIXELS;
    const uint2 tile = place / parts;
    const uint2 part = place % parts;
    PartThread thread;
    thread.index = place.y * parts.x * GROUP_TILES_ACROSS + place.x;
    thread.tile = tile.y * GROUP_TILES_ACROSS + tile.x;
    thread.part = part.y * parts.x + part.x;
    thread.firstPixel = int2(place) * PART_PIXELS;
    return thread;
}

// The part's place in its tile, counted in parts.
int2 PartOfTile(uint part)
{
    return int2(part % (TILE_PIXELS / PART_PIXELS), part / (TILE_PIXELS / PART_PIXELS));
}

int2 PixelOfPart(uint lane)
{
    return int2(lane % PART_PIXELS, lane / PART_PIXELS);
}

// A bit for each of a part's pixels that lie in the target; firstPixel is the part's first.
uint PixelsInTarget(int2 firstPixel, int2 size)
{
    uint pixels = 0;
    PENUMBRA_LOOP
    for (uint lane = 0; lane < PART_LANES; ++lane)
    {
        if (all(firstPixel + PixelOfPart(lane) < size)) pixels |= 1u << lane;
    }
    return pixels;
}

PartReceivers NoReceivers()
{
    return (PartReceivers)0;
}

PartReceivers FirstReceiver(QuadReceiver receiver, int cascade, uint lane)
{
    PartReceivers part;
    part.any = true;
    part.pixels = 1u << lane;
    part.cascade = uint(cascade);
    part.group = GroupOf(receiver);
    part.low = receiver.centre;
    part.high = receiver.centre;
    return part;
}

// The part with another receiver, or as it is where that one is of another cascade or far from its plane.
PartReceivers JoinReceiver(PartReceivers part, QuadReceiver receiver, int cascade, uint lane, ConeScales scales)
{
    const ReceiverGroup joined = JoinGroup(part.group, receiver);
    const float depthPerTexel = scales.depthPerMetre / max(scales.texelsPerMetre, 1e-9);
    const bool apart = uint(cascade) != part.cascade || joined.planeError > kPartDepthTexels * depthPerTexel;
    PartReceivers next = part;
    if (!apart)
    {
        next.group = joined;
        next.pixels = part.pixels | (1u << lane);
        next.low = min(part.low, receiver.centre);
        next.high = max(part.high, receiver.centre);
    }
    return next;
}

// Threads call it before the group's first barrier.
void ResetClusters(uint thread)
{
    PENUMBRA_LOOP
    for (uint i = thread; i < GROUP_TILES * TILE_CLUSTERS * (MOST_RADII + 1); i += GROUP_THREADS) clusterRadius[i] = 0;
    if (thread >= GROUP_TILES * TILE_CLUSTERS) return;
    clusterFirst[thread] = TILE_PARTS;
    clusterLeft[thread] = 0x7fffffff;
    clusterTop[thread] = 0x7fffffff;
    clusterRight[thread] = -2147483647;
    clusterBottom[thread] = -2147483647;
}

// Clusters begin with parts in the tile's middle, because the tile's edges see what else lies there.
uint ClusterOrder(uint part)
{
    return (part + TILE_PARTS / 2 + TILE_PIXELS / PART_PIXELS / 2) % TILE_PARTS;
}

// Whether the part belongs to its tile's next cluster, and so is near the first of the parts that wait.
bool JoinCluster(PartReceivers part, PartThread thread, uint cluster)
{
    const uint own = thread.tile * TILE_CLUSTERS + cluster;
    if (part.any) InterlockedMin(clusterFirst[own], ClusterOrder(thread.part));
    GroupMemoryBarrierWithGroupSync();
    if (ClusterOrder(thread.part) == clusterFirst[own])
    {
        clusterCentre[own] = part.group.first.centre;
        clusterCascade[own] = part.cascade;
    }
    GroupMemoryBarrierWithGroupSync();
    const float2 away = abs(part.group.first.centre - clusterCentre[own]);
    const bool joins = part.any && part.cascade == clusterCascade[own] && max(away.x, away.y) <= kClusterTexels;
    if (joins)
    {
        const int2 low = int2(floor(part.low));
        const int2 high = int2(floor(part.high));
        InterlockedMin(clusterLeft[own], low.x);
        InterlockedMin(clusterTop[own], low.y);
        InterlockedMax(clusterRight[own], high.x);
        InterlockedMax(clusterBottom[own], high.y);
    }
    return joins;
}

// bounds and scales are those of the cluster's cascade.
PartDecision DecidePart(TEXTURE2D(depthPlanes), TEXTURE2D(coarsePlanes), bool joins, ReceiverGroup group,
                        TileBounds bounds, ConeScales scales, PcssAngularParameters parameters, PartThread thread,
                        uint cluster)
{
    const uint own = thread.tile * TILE_CLUSTERS + cluster;
    const float smallest = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    LightCone cone;
    cone.scales = scales;
    cone.slackTexels = smallest + kWidestSlackTexels;
    cone.largestOffset = BoundedOrLow(parameters.maxSamplingMetres, 0.0, 1e6) * scales.depthPerMetre;
    const float narrowest = max(max(smallest, kWidestBlockTexels), kSmallestClusterRadius);
    PartDecision decision;
    decision.visibility = kUndecided;
    decision.radius = max(SearchRadius(group.depths.y, parameters.maxPenumbraMetres, smallest, scales), narrowest);
    // Floats of one sign have the order of their bits.
    if (joins) InterlockedMax(clusterRadius[own * (MOST_RADII + 1)], asuint(decision.radius));
    GroupMemoryBarrierWithGroupSync();
    const float2 clusterLow = float2(clusterLeft[own], clusterTop[own]);
    const float2 clusterHigh = float2(clusterRight[own], clusterBottom[own]) + 1.0;
    bool settled = clusterFirst[own] == TILE_PARTS;
    float radius = asfloat(clusterRadius[own * (MOST_RADII + 1)]);
    PENUMBRA_LOOP
    for (uint i = 0; i < MOST_RADII; ++i)
    {
        const float clusterReach = radius + kSampleReachTexels;
        const DiscBlocks blocks = BlocksOfBox(clusterLow - clusterReach, clusterHigh + clusterReach,
                                              i == 0 ? kFirstBlocksAcross : MOST_BLOCKS_ACROSS, bounds);
        const float blockTexels = kRangeBlock * PowerOfTwo(blocks.level);
        const int2 size = blocks.whole && !settled ? blocks.high - blocks.low + 1 : int2(0, 0);
        const uint firstBlock = thread.tile * MOST_BLOCKS_ACROSS * MOST_BLOCKS_ACROSS;
        PENUMBRA_LOOP
        for (int k = int(thread.part); k < MOST_BLOCKS_ACROSS * size.y; k += TILE_PARTS)
        {
            const int2 block = PlaceInRows(k, MOST_BLOCKS_ACROSS);
            if (block.x >= size.x) continue;
            if (blocks.level == 0) clusterBlocks[firstBlock + k] = LOAD_TEXTURE2D(depthPlanes, blocks.low + block);
            else clusterBlocks[firstBlock + k] = LOAD_TEXTURE2D_LOD(coarsePlanes, blocks.low + block, blocks.level - 1);
        }
        GroupMemoryBarrierWithGroupSync();
        if (joins && !settled && decision.visibility < 0.0)
        {
            const float reach = decision.radius + kSampleReachTexels;
            const float2 first = group.first.centre / blockTexels;
            const float across = (group.spread + reach) / blockTexels;
            const int2 low = max(int2(floor(first - across)) - blocks.low, 0);
            const int2 high = min(int2(floor(first + across)) - blocks.low, size - 1);
            float gap = blocks.whole ? 0.0 : kAnyGap;
            float smallestGap = kAnyGap;
            bool allAbove = blocks.whole;
            PENUMBRA_LOOP
            for (int y = low.y; y <= high.y; ++y)
            {
                PENUMBRA_LOOP
                for (int x = low.x; x <= high.x; ++x)
                {
                    const float2 away = (float2(blocks.low + int2(x, y)) + 0.5) * blockTexels - group.first.centre;
                    const DepthPlanes planes = UnpackPlanes(clusterBlocks[firstBlock + y * MOST_BLOCKS_ACROSS + x]);
                    const GroupBounds block = BoundBlock(planes, away, blockTexels, reach, group);
                    if (block.nearest > reach) continue;
                    const float offset = ConeOffset(block.nearest, cone.slackTexels, cone.largestOffset, cone.scales);
                    if (!block.noneAbove && block.largestGap > offset) gap = max(gap, block.largestGap);
                    smallestGap = min(smallestGap, max(block.smallestGap, 0.0));
                    allAbove = allAbove && block.allAbove;
                }
            }
            const float next = max(min(PenumbraRadius(gap, scales), decision.radius), narrowest);
            if (!(gap > 0.0)) decision.visibility = 1.0;
            else if (allAbove && smallestGap > kRoundedShare * kConeHeightShare * gap) decision.visibility = 0.0;
            else InterlockedMax(clusterRadius[own * (MOST_RADII + 1) + i + 1], asuint(next));
            decision.radius = next;
        }
        GroupMemoryBarrierWithGroupSync();
        const float nextRadius = asfloat(clusterRadius[own * (MOST_RADII + 1) + i + 1]);
        // The first radius is tried with few blocks.
        settled = settled || !(nextRadius > 0.0) || (i > 0 && nextRadius > kShrinks * radius);
        radius = nextRadius;
    }
    return decision;
}

// A tile in the list has a word for its place and one for each part.
#define TILE_WORDS 17

// The place has 15 bits across, which are enough for 524,288 pixels, one for the eye, and 16 down.
uint PlaceOfTile(int2 pixel, uint eye)
{
    const uint2 tile = uint2(pixel) / TILE_PIXELS;
    return tile.x | (eye << 15) | (tile.y << 16);
}

int2 FirstPixelOfTile(uint place)
{
    return TILE_PIXELS * int2(place & 0x7fffu, place >> 16);
}

uint EyeOfTile(uint place)
{
    return (place >> 15) & 1;
}

// A part's word holds which of its pixels are undecided, and a radius, texels, that no blocker's penumbra there
// exceeds.
uint PackPart(uint undecided, float radius)
{
    // This is the smallest half that is no less, as far as halves go.
    const uint stored = f32tof16(min(radius, kWidestHalf));
    return (undecided << 16) | (f16tof32(stored) < radius && stored < 0x7bffu ? stored + 1 : stored);
}

uint UndecidedOfPart(uint word)
{
    return word >> 16;
}

float RadiusOfPart(uint word)
{
    return f16tof32(word & 0xffffu);
}

#endif
