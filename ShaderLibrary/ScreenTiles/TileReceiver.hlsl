// Penumbra: the visibility of receivers that no window of TileWindows.hlsl takes, each by the 16 threads of a part.
//
// Computes:   what RingVisibility of CellFilter.hlsl does for one receiver, whose cells the threads share;
//             16 receivers of a tile at once. One thread alone would keep its group waiting for some 50 reads, one
//             after the other.
// Source:     Penumbra's own.
// Inputs:     the shadow map; spreads and coarseSpreads, of the kernels FirstLevels and NextLevel; the receivers, from
//             PutRestReceiver.
// Cost:       that of FilterDepthRings, less its decision: some 50 fetches for each receiver. No groupshared memory but
//             what TileWindows.hlsl has, whose windows are lost.
// Guarantees: [0, 1]; that of RingVisibility but for the order of the sums; the same threads add in the same order.
// Use it:     in kernels of WINDOW_THREADS threads, all of which call RingVisibilityByPart; after the windows have been
//             used, and a barrier.
#ifndef PENUMBRA_TILE_RECEIVER_HLSL
#define PENUMBRA_TILE_RECEIVER_HLSL

#include "TileWindows.hlsl"
#include "../Filters/Cells/CellFilter.hlsl"

// windowSpreads holds five words of each thread, as many of each part, and two of each part's receiver. sharedDepths
// holds five of each of these.
#define REST_SUMS 5
#define REST_TOTALS (REST_SUMS * WINDOW_THREADS)
#define REST_RADII (REST_TOTALS + REST_SUMS * TILE_PARTS)
#define REST_PLACES (REST_RADII + TILE_PARTS)
#define REST_FLOATS 5

void PutNoReceiver(uint part)
{
    windowSpreads[REST_PLACES + part] = 0xffffu;
}

// No blocker's penumbra is wider than radius, texels. thread is that of the receiver's pixel.
void PutRestReceiver(QuadReceiver receiver, float radius, int cascade, uint thread, uint part)
{
    const uint first = REST_FLOATS * part;
    sharedDepths[first] = receiver.centre.x;
    sharedDepths[first + 1] = receiver.centre.y;
    sharedDepths[first + 2] = receiver.gradient.x;
    sharedDepths[first + 3] = receiver.gradient.y;
    sharedDepths[first + 4] = receiver.depth;
    windowSpreads[REST_RADII + part] = asuint(radius);
    windowSpreads[REST_PLACES + part] = thread | (uint(cascade) << 16);
}

// The thread whose pixel the part's receiver belongs to; WINDOW_THREADS or more where there is none.
uint ThreadOfRest(uint part)
{
    return windowSpreads[REST_PLACES + part] & 0xffffu;
}

uint CascadeOfRest(uint part)
{
    return windowSpreads[REST_PLACES + part] >> 16;
}

QuadReceiver RestReceiver(uint part, ShadowTile tile)
{
    const uint first = REST_FLOATS * part;
    QuadReceiver receiver = PrepareQuads((ShadowReceiver)0, tile);
    receiver.centre = float2(sharedDepths[first], sharedDepths[first + 1]);
    receiver.gradient = float2(sharedDepths[first + 2], sharedDepths[first + 3]);
    receiver.depth = sharedDepths[first + 4];
    return receiver;
}

void PutSum(float value, uint sum, uint thread)
{
    windowSpreads[sum * WINDOW_THREADS + thread] = asuint(value);
}

// Adds the numbers of all threads of the part. It has all barriers that this needs, which all threads of the group
// pass.
void AddSums(bool active, uint thread)
{
    const uint sum = thread % PART_LANES;
    const uint part = thread / PART_LANES;
    GroupMemoryBarrierWithGroupSync();
    if (active && sum < REST_SUMS)
    {
        float total = 0.0;
        PENUMBRA_LOOP
        for (uint lane = 0; lane < PART_LANES; ++lane)
            total += asfloat(windowSpreads[sum * WINDOW_THREADS + part * PART_LANES + lane]);
        windowSpreads[REST_TOTALS + part * REST_SUMS + sum] = asuint(total);
    }
    GroupMemoryBarrierWithGroupSync();
}

float TotalOf(uint sum, uint part)
{
    return asfloat(windowSpreads[REST_TOTALS + part * REST_SUMS + sum]);
}

void PutSearch(RingSearch search, uint thread)
{
    PutSum(search.sums.inside.x, 0, thread);
    PutSum(search.sums.inside.y, 1, thread);
    PutSum(search.sums.nearby.x, 2, thread);
    PutSum(search.sums.nearby.y, 3, thread);
    PutSum(search.low, 4, thread);
}

// The search with what the part's threads have found.
RingSearch SearchOfPart(RingSearch search, uint part)
{
    RingSearch all = search;
    all.sums.inside = float2(TotalOf(0, part), TotalOf(1, part));
    all.sums.nearby = float2(TotalOf(2, part), TotalOf(3, part));
    all.low = TotalOf(4, part);
    return all;
}

// The threads of a part compute the visibility of its receiver. Threads that are not active get 1.
float RingVisibilityByPart(TEXTURE2D_PARAM(shadowMap, sampler_point), Texture2D<uint4> depthSpreads,
                           Texture2D<uint4> coarseSpreads, bool active, ShadowTile tile, uint thread)
{
    const uint part = thread / PART_LANES;
    QuadShare share;
    share.first = int(thread % PART_LANES);
    share.step = PART_LANES;
    QuadReceiver receiver = (QuadReceiver)0;
    ConeScales scales = (ConeScales)0;
    RingSearch search = (RingSearch)0;
    float radius = 0.0;
    if (share.first == 0) partGround[part] = 0x7f7fffffu;
    GroupMemoryBarrierWithGroupSync();
    if (active)
    {
        receiver = RestReceiver(part, tile);
        scales = ConeScalesOf(tile);
        radius = asfloat(windowSpreads[REST_RADII + part]);
        search = BeginSearch(scales);
        search = SearchRingTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), search, share, radius, receiver, scales);
        if (search.groundFound) InterlockedMin(partGround[part], asuint(search.ground));
    }
    GroupMemoryBarrierWithGroupSync();
    if (active)
    {
        search.ground = GroundOfPart(part, scales);
        search = SearchRingCells(depthSpreads, coarseSpreads, search, share, radius, receiver, scales);
        PutSearch(search, thread);
    }
    AddSums(active, thread);
    RingPenumbra penumbra = (RingPenumbra)0;
    if (active)
    {
        penumbra = PenumbraOf(SearchOfPart(search, part), radius, scales);
        float2 block = float2(0.0, 0.0);
        float2 disc = float2(0.0, 0.0);
        if (penumbra.blocked && penumbra.readsBlock)
            block = SumRingBlock(TEXTURE2D_ARGS(shadowMap, sampler_point), penumbra, share, receiver);
        if (penumbra.blocked && penumbra.readsDisc)
            disc = SumRingDisc(TEXTURE2D_ARGS(shadowMap, sampler_point), depthSpreads, coarseSpreads, penumbra, share,
                               receiver);
        PutSum(block.x, 0, thread);
        PutSum(block.y, 1, thread);
        PutSum(disc.x, 2, thread);
        PutSum(disc.y, 3, thread);
    }
    AddSums(active, thread);
    float visibility = 1.0;
    if (penumbra.blocked && penumbra.readsBlock) visibility = LitShare(TotalOf(0, part), TotalOf(1, part));
    if (penumbra.blocked && penumbra.readsDisc)
        visibility = min(visibility, LitShare(TotalOf(2, part), TotalOf(3, part)));
    return SanitizeVisibility(visibility);
}

#endif
