// Penumbra: which pixels of a tile are lit or dark as a whole, decided by the group of its threads.
//
// Computes:   clusters of a tile's receivers, those of one cascade near one plane; and for each whether PCSS by angular
//             diameter gives 1 at all of them, 0 at all of them, or may give anything.
// Source:     the decision of Filters/PcssAngularDecision.hlsl, with 16 threads that read a block each instead of a search.
// Inputs:     QuadReceiver and ShadowTile of each thread; depthPlanes; PcssAngularParameters.
// Cost:       up to 16 fetches for each of up to 4 radii, each of which is what the blocks of the one before allow.
// Guarantees: those of PcssAngularDecision.hlsl. All threads of the group call the functions with barriers, in the same order.
// Use it:     in kernels of 8 x 8 threads.
#ifndef PENUMBRA_TILE_CLUSTERS_HLSL
#define PENUMBRA_TILE_CLUSTERS_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Filters/PcssAngularDecision.hlsl"

#define TILE_THREADS 64
// Those that are left are decided by nobody. With 1 a tenth of the pixels of the street are left, with 3 less than a hundredth.
#define TILE_CLUSTERS 3

// Receivers of a cluster: how far from its first in texels, and from its plane in texels of its cascade, along the light.
static const float kClusterTexels = 24.0;
static const float kClusterDepthTexels = 4.0;
static const int kMostRadii = 4;
static const int kBlocksEach = 6;
// A radius that shrinks by less is not tried again.
static const float kShrinks = 0.75;
static const float kSmallestClusterRadius = 2.0;

groupshared uint clusterFirst;
groupshared QuadReceiver clusterReceiver;
groupshared ShadowTile clusterTile;
groupshared uint clusterCascade;
groupshared uint clusterSpread;
groupshared uint clusterLow;
groupshared uint clusterHigh;
groupshared uint clusterPlaneError;
groupshared uint clusterTilt;
groupshared uint clusterGap;
groupshared uint clusterSmallestGap;
groupshared uint clusterNotAllAbove;

// From the tile's middle: its edges see what else lies there.
uint ClusterOrder(uint thread)
{
    return (thread + 36) % TILE_THREADS;
}

// The first of the threads that wait is the cluster's first; TILE_THREADS: none waits.
void ChooseCluster(bool waits, uint thread, QuadReceiver receiver, ShadowTile tile, int cascade)
{
    GroupMemoryBarrierWithGroupSync();
    if (thread == 0) clusterFirst = TILE_THREADS;
    GroupMemoryBarrierWithGroupSync();
    if (waits) InterlockedMin(clusterFirst, ClusterOrder(thread));
    GroupMemoryBarrierWithGroupSync();
    if (ClusterOrder(thread) == clusterFirst || (clusterFirst == TILE_THREADS && thread == 0))
    {
        clusterReceiver = receiver;
        clusterTile = tile;
        clusterCascade = uint(cascade);
    }
    GroupMemoryBarrierWithGroupSync();
}

// Bounds of those that join. Floats of one sign have the order of their bits.
ReceiverGroup BoundCluster(bool joins, uint thread, QuadReceiver receiver)
{
    const ReceiverGroup own = JoinGroup(GroupOf(clusterReceiver), receiver);
    if (thread == 0)
    {
        clusterSpread = 0;
        clusterLow = 0x7f800000u;
        clusterHigh = 0;
        clusterPlaneError = 0;
        clusterTilt = 0;
    }
    GroupMemoryBarrierWithGroupSync();
    if (joins)
    {
        InterlockedMax(clusterSpread, asuint(own.spread));
        InterlockedMin(clusterLow, asuint(receiver.depth));
        InterlockedMax(clusterHigh, asuint(receiver.depth));
        InterlockedMax(clusterPlaneError, asuint(own.planeError));
        InterlockedMax(clusterTilt, asuint(own.tilt));
    }
    GroupMemoryBarrierWithGroupSync();
    ReceiverGroup group = GroupOf(clusterReceiver);
    group.spread = asfloat(clusterSpread);
    group.depths = JoinRanges(float2(asfloat(clusterLow), asfloat(clusterLow)), float2(asfloat(clusterHigh), asfloat(clusterHigh)));
    group.planeError = asfloat(clusterPlaneError);
    group.tilt = asfloat(clusterTilt);
    return group;
}

bool JoinsCluster(QuadReceiver receiver, int cascade)
{
    const ReceiverGroup own = JoinGroup(GroupOf(clusterReceiver), receiver);
    const ConeScales scales = ConeScalesOf(clusterTile);
    const float depthPerTexel = scales.depthPerMetre / max(scales.texelsPerMetre, 1e-9);
    return uint(cascade) == clusterCascade && own.spread <= kClusterTexels &&
           own.planeError <= kClusterDepthTexels * depthPerTexel;
}

// 1 lit, 0 dark, kUndecided: then radius bounds that of every blocker's penumbra, texels.
float DecideCluster(TEXTURE2D(depthPlanes), ReceiverGroup group, PcssAngularParameters parameters, uint thread,
                    out float radius)
{
    const float smallest = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    LightCone cone;
    cone.scales = ConeScalesOf(clusterTile);
    cone.slackTexels = smallest + kWidestSlackTexels;
    cone.largestOffset = BoundedOrLow(parameters.maxSamplingMetres, 0.0, 1e6) * cone.scales.depthPerMetre;
    const float narrowest = max(max(smallest, kWidestBlockTexels), kSmallestClusterRadius);
    radius = max(SearchRadius(group.depths.y, parameters.maxPenumbraMetres, smallest, cone.scales), narrowest);
    float decided = kUndecided;
    bool settled = clusterFirst == TILE_THREADS;
    UNITY_LOOP
    for (int i = 0; i < kMostRadii; ++i)
    {
        if (thread == 0)
        {
            clusterGap = 0;
            clusterSmallestGap = asuint(kAnyGap);
            clusterNotAllAbove = 0;
        }
        GroupMemoryBarrierWithGroupSync();
        const float reach = radius + kSampleReachTexels;
        const DiscBlocks blocks = BlocksOfDisc(group.first.centre, reach + group.spread, kBlocksEach, group.first.bounds);
        const int2 texel = blocks.low + int2(thread % kBlocksEach, thread / kBlocksEach);
        const bool reads = !settled && thread < kBlocksEach * kBlocksEach && all(texel <= blocks.high);
        if (!blocks.whole)
        {
            clusterGap = asuint(kAnyGap);
            clusterNotAllAbove = 1;
        }
        else if (reads)
        {
            const float blockTexels = kRangeBlock * exp2(float(blocks.level));
            const float2 away = (float2(texel) + 0.5) * blockTexels - group.first.centre;
            if (length(max(abs(away) - 0.5 * blockTexels, 0.0)) <= group.spread + reach)
            {
                const DepthPlanes planes = UnpackPlanes(LOAD_TEXTURE2D_LOD(depthPlanes, texel, blocks.level));
                const GroupBounds block = BoundBlock(planes, away, blockTexels, reach, group);
                const float offset = ConeOffset(block.nearest, cone.slackTexels, cone.largestOffset, cone.scales);
                if (!block.noneAbove && block.largestGap > offset)
                    InterlockedMax(clusterGap, asuint(max(block.largestGap, 0.0)));
                InterlockedMin(clusterSmallestGap, asuint(max(block.smallestGap, 0.0)));
                if (!block.allAbove) clusterNotAllAbove = 1;
            }
        }
        GroupMemoryBarrierWithGroupSync();
        if (!settled)
        {
            const float gap = asfloat(clusterGap);
            const bool dark = clusterNotAllAbove == 0 && asfloat(clusterSmallestGap) > 1.001 * kConeHeightShare * gap;
            const float next = max(min(PenumbraRadius(gap, cone.scales), radius), narrowest);
            if (!(gap > 0.0)) decided = 1.0;
            else if (dark) decided = 0.0;
            settled = !(gap > 0.0) || dark || next > kShrinks * radius;
            radius = next;
        }
        GroupMemoryBarrierWithGroupSync();
    }
    return decided;
}

#endif
