// Penumbra: which pixels of a tile are lit or dark, decided by the group of its threads.
//
// Computes:   clusters of a tile's receivers, near each other in one cascade, which read the same blocks of the shadow map;
//             and for each part of 4 x 4 pixels whether PCSS by angular diameter gives 1 at all of its receivers, 0 at all
//             of them, or may give anything.
// Source:     the decision of Filters/PcssAngularDecision.hlsl, over blocks in groupshared memory instead of a search.
// Inputs:     QuadReceiver and ShadowTile of each thread; depthPlanes, of 4 x 4 texels, and coarsePlanes, of 8 x 8, with mip
//             levels; PcssAngularParameters.
// Cost:       for a cluster up to 16 fetches for the first radius and 64 for each of up to 3 more, each of which is what the
//             blocks of the one before allow: a quarter of a fetch per pixel for 64.
// Guarantees: those of PcssAngularDecision.hlsl. All threads of the group call the functions with barriers, in the same order.
// Use it:     in kernels of 16 x 16 threads.
#ifndef PENUMBRA_TILE_CLUSTERS_HLSL
#define PENUMBRA_TILE_CLUSTERS_HLSL

#include "TileSurfaces.hlsl"
#include "../ShaderLibrary/Filters/PcssAngularDecision.hlsl"

#define TILE_THREADS 256
// Receivers of 4 x 4 pixels, which 16 threads decide together.
#define TILE_PARTS 16
#define PART_PIXELS 4
#define PART_THREADS 16
// What is left after these is decided by nobody.
#define TILE_CLUSTERS 4
#define MOST_BLOCKS_ACROSS 8

// How far a receiver of a cluster lies from its first, texels along each axis; and one of a part from the plane of the part's
// first, in texels of its cascade along the light.
static const float kClusterTexels = 24.0;
static const float kPartDepthTexels = 4.0;
static const int kMostRadii = 4;
static const int kFirstBlocksAcross = 4;
// A radius that shrinks by less is not tried again.
static const float kShrinks = 0.75;
static const float kSmallestClusterRadius = 2.0;

groupshared uint clusterFirst;
groupshared float2 clusterCentre;
groupshared float2 clusterTexelSize;
groupshared ShadowTile clusterTile;
groupshared uint clusterCascade;
groupshared int clusterLeft;
groupshared int clusterTop;
groupshared int clusterRight;
groupshared int clusterBottom;
groupshared uint clusterRadius;
groupshared uint clusterNextRadius;
groupshared float4 clusterBlocks[MOST_BLOCKS_ACROSS * MOST_BLOCKS_ACROSS];

groupshared uint partFirst[TILE_PARTS];
groupshared QuadReceiver partReceiver[TILE_PARTS];
groupshared uint partSpread[TILE_PARTS];
groupshared uint partLow[TILE_PARTS];
groupshared uint partHigh[TILE_PARTS];
groupshared uint partPlaneError[TILE_PARTS];
groupshared uint partTilt[TILE_PARTS];
groupshared uint partGap[TILE_PARTS];
groupshared uint partSmallestGap[TILE_PARTS];
groupshared uint partNotAllAbove[TILE_PARTS];
groupshared float partRadius[TILE_PARTS];
groupshared float partDecided[TILE_PARTS];
groupshared uint partUndecided[TILE_PARTS];
groupshared uint partWidest[TILE_PARTS];

// Of a tile in the list: where it lies, and a word for each part.
#define TILE_WORDS 17

// A part's word: which of its pixels are undecided, and a radius, texels, that no blocker's penumbra there exceeds.
uint PackPart(uint undecided, float radius)
{
    // The smallest half that is no less.
    const uint stored = f32tof16(radius);
    return (undecided << 16) | (f16tof32(stored) < radius ? stored + 1 : stored);
}

struct TileThread
{
    uint index;
    uint part;
    uint lane; // in its part
};

TileThread ThreadAt(uint2 pixelOfTile)
{
    TileThread thread;
    thread.index = pixelOfTile.y * TILE_PIXELS + pixelOfTile.x;
    thread.part = (pixelOfTile.y / PART_PIXELS) * (TILE_PIXELS / PART_PIXELS) + pixelOfTile.x / PART_PIXELS;
    thread.lane = (pixelOfTile.y % PART_PIXELS) * PART_PIXELS + pixelOfTile.x % PART_PIXELS;
    return thread;
}

// From the tile's middle: its edges see what else lies there.
uint ClusterOrder(uint thread)
{
    return (thread + TILE_THREADS / 2 + TILE_PIXELS / 2) % TILE_THREADS;
}

// The first of the threads that wait is the cluster's first; TILE_THREADS: none waits.
void ChooseCluster(bool waits, TileThread thread, QuadReceiver receiver, ShadowTile tile, int cascade)
{
    GroupMemoryBarrierWithGroupSync();
    if (thread.index == 0)
    {
        clusterFirst = TILE_THREADS;
        clusterLeft = 0x7fffffff;
        clusterTop = 0x7fffffff;
        clusterRight = -0x7fffffff;
        clusterBottom = -0x7fffffff;
        clusterRadius = 0;
    }
    GroupMemoryBarrierWithGroupSync();
    if (waits) InterlockedMin(clusterFirst, ClusterOrder(thread.index));
    GroupMemoryBarrierWithGroupSync();
    if (ClusterOrder(thread.index) == clusterFirst || (clusterFirst == TILE_THREADS && thread.index == 0))
    {
        clusterCentre = receiver.centre;
        clusterTexelSize = receiver.texelSize;
        clusterTile = tile;
        clusterCascade = uint(cascade);
    }
    GroupMemoryBarrierWithGroupSync();
}

// reach: texels along each axis.
bool IsNearCluster(QuadReceiver receiver, int cascade, float reach)
{
    const float2 away = abs(receiver.centre - clusterCentre);
    return uint(cascade) == clusterCascade && max(away.x, away.y) <= reach;
}

// The texels of those that join.
void BoundCluster(bool joins, QuadReceiver receiver)
{
    if (!joins) return;
    const int2 texel = int2(floor(receiver.centre));
    InterlockedMin(clusterLeft, texel.x);
    InterlockedMin(clusterTop, texel.y);
    InterlockedMax(clusterRight, texel.x);
    InterlockedMax(clusterBottom, texel.y);
}

// Whether the thread is one of its part's group: near the plane of the first. Floats of one sign have the order of their bits.
bool JoinParts(bool near, TileThread thread, QuadReceiver receiver)
{
    if (thread.lane == 0)
    {
        partFirst[thread.part] = PART_THREADS;
        partSpread[thread.part] = 0;
        partLow[thread.part] = 0x7f800000u;
        partHigh[thread.part] = 0;
        partPlaneError[thread.part] = 0;
        partTilt[thread.part] = 0;
    }
    GroupMemoryBarrierWithGroupSync();
    if (near) InterlockedMin(partFirst[thread.part], thread.lane);
    GroupMemoryBarrierWithGroupSync();
    if (thread.lane == partFirst[thread.part] || (thread.lane == 0 && partFirst[thread.part] == PART_THREADS))
        partReceiver[thread.part] = receiver;
    GroupMemoryBarrierWithGroupSync();
    const ConeScales scales = ConeScalesOf(clusterTile);
    const float depthPerTexel = scales.depthPerMetre / max(scales.texelsPerMetre, 1e-9);
    const ReceiverGroup own = JoinGroup(GroupOf(partReceiver[thread.part]), receiver);
    const bool joins = near && own.planeError <= kPartDepthTexels * depthPerTexel;
    if (joins)
    {
        InterlockedMax(partSpread[thread.part], asuint(own.spread));
        InterlockedMin(partLow[thread.part], asuint(receiver.depth));
        InterlockedMax(partHigh[thread.part], asuint(receiver.depth));
        InterlockedMax(partPlaneError[thread.part], asuint(own.planeError));
        InterlockedMax(partTilt[thread.part], asuint(own.tilt));
    }
    GroupMemoryBarrierWithGroupSync();
    return joins;
}

ReceiverGroup GroupOfPart(uint part)
{
    ReceiverGroup group = GroupOf(partReceiver[part]);
    const float low = asfloat(partLow[part]);
    const float high = asfloat(partHigh[part]);
    group.spread = asfloat(partSpread[part]);
    group.depths = JoinRanges(float2(low, low), float2(high, high));
    group.planeError = asfloat(partPlaneError[part]);
    group.tilt = asfloat(partTilt[part]);
    return group;
}

// From the texels of the cluster's receivers to a block, texels.
float DistanceFromCluster(int2 block, float blockTexels)
{
    const float2 low = float2(block) * blockTexels;
    const float2 before = float2(clusterLeft, clusterTop) - (low + blockTexels);
    const float2 behind = low - (float2(clusterRight, clusterBottom) + 1.0);
    return length(max(max(before, behind), 0.0));
}

// partDecided: 1 lit, 0 dark, kUndecided: then partRadius bounds that of every blocker's penumbra, texels.
void DecideParts(TEXTURE2D(depthPlanes), TEXTURE2D(coarsePlanes), ReceiverGroup group, PcssAngularParameters parameters,
                 TileThread thread)
{
    const float smallest = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    LightCone cone;
    cone.scales = ConeScalesOf(clusterTile);
    cone.slackTexels = smallest + kWidestSlackTexels;
    cone.largestOffset = BoundedOrLow(parameters.maxSamplingMetres, 0.0, 1e6) * cone.scales.depthPerMetre;
    const TileBounds bounds = BoundsInTexels(clusterTile);
    const float narrowest = max(max(smallest, kWidestBlockTexels), kSmallestClusterRadius);
    const bool anyone = partFirst[thread.part] < PART_THREADS;
    if (thread.lane == 0)
    {
        const float search = SearchRadius(group.depths.y, parameters.maxPenumbraMetres, smallest, cone.scales);
        partRadius[thread.part] = max(search, narrowest);
        partDecided[thread.part] = kUndecided;
        if (anyone) InterlockedMax(clusterRadius, asuint(partRadius[thread.part]));
    }
    GroupMemoryBarrierWithGroupSync();
    bool settled = clusterFirst == TILE_THREADS;
    float radius = asfloat(clusterRadius);
    UNITY_LOOP
    for (int i = 0; i < kMostRadii; ++i)
    {
        if (thread.index == 0) clusterNextRadius = 0;
        if (thread.lane == 0)
        {
            partGap[thread.part] = 0;
            partSmallestGap[thread.part] = asuint(kAnyGap);
            partNotAllAbove[thread.part] = 0;
        }
        const float clusterReach = radius + kSampleReachTexels;
        const DiscBlocks blocks =
            BlocksOfBox(float2(clusterLeft, clusterTop) - clusterReach,
                        float2(clusterRight, clusterBottom) + 1.0 + clusterReach,
                        i == 0 ? kFirstBlocksAcross : MOST_BLOCKS_ACROSS, bounds);
        const float blockTexels = kRangeBlock * exp2(float(blocks.level));
        const int2 size = blocks.whole && !settled ? blocks.high - blocks.low + 1 : int2(0, 0);
        const int2 own = int2(int(thread.index) % max(size.x, 1), int(thread.index) / max(size.x, 1));
        if (own.y < size.y && DistanceFromCluster(blocks.low + own, blockTexels) <= clusterReach)
        {
            const int2 texel = blocks.low + own;
            if (blocks.level == 0) clusterBlocks[thread.index] = LOAD_TEXTURE2D(depthPlanes, texel);
            else clusterBlocks[thread.index] = LOAD_TEXTURE2D_LOD(coarsePlanes, texel, blocks.level - 1);
        }
        GroupMemoryBarrierWithGroupSync();
        const float reach = partRadius[thread.part] + kSampleReachTexels;
        float gap = blocks.whole ? 0.0 : kAnyGap;
        float smallestGap = kAnyGap;
        bool allAbove = blocks.whole;
        const int count = anyone ? size.x * size.y : 0;
        UNITY_LOOP
        for (int k = int(thread.lane); k < count; k += PART_THREADS)
        {
            const int2 texel = blocks.low + int2(k % size.x, k / size.x);
            const float2 away = (float2(texel) + 0.5) * blockTexels - group.first.centre;
            if (length(max(abs(away) - 0.5 * blockTexels, 0.0)) > group.spread + reach) continue;
            if (DistanceFromCluster(texel, blockTexels) > clusterReach) continue;
            const GroupBounds block = BoundBlock(UnpackPlanes(clusterBlocks[k]), away, blockTexels, reach, group);
            const float offset = ConeOffset(block.nearest, cone.slackTexels, cone.largestOffset, cone.scales);
            if (!block.noneAbove && block.largestGap > offset) gap = max(gap, block.largestGap);
            smallestGap = min(smallestGap, max(block.smallestGap, 0.0));
            allAbove = allAbove && block.allAbove;
        }
        InterlockedMax(partGap[thread.part], asuint(gap));
        InterlockedMin(partSmallestGap[thread.part], asuint(smallestGap));
        if (!allAbove) partNotAllAbove[thread.part] = 1;
        GroupMemoryBarrierWithGroupSync();
        if (thread.lane == 0 && anyone && !settled && partDecided[thread.part] < 0.0)
        {
            const float partsGap = asfloat(partGap[thread.part]);
            const bool dark = partNotAllAbove[thread.part] == 0 &&
                              asfloat(partSmallestGap[thread.part]) > 1.001 * kConeHeightShare * partsGap;
            const float next = max(min(PenumbraRadius(partsGap, cone.scales), partRadius[thread.part]), narrowest);
            if (!(partsGap > 0.0)) partDecided[thread.part] = 1.0;
            else if (dark) partDecided[thread.part] = 0.0;
            else InterlockedMax(clusterNextRadius, asuint(next));
            partRadius[thread.part] = next;
        }
        GroupMemoryBarrierWithGroupSync();
        const float next = asfloat(clusterNextRadius);
        // The first radius is tried with few blocks.
        settled = settled || !(next > 0.0) || (i > 0 && next > kShrinks * radius);
        if (!settled) radius = next;
        GroupMemoryBarrierWithGroupSync();
    }
}

#endif
