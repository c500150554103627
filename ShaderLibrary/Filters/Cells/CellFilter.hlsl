// Penumbra: soft shadows from all texels of the shadow map around one receiver, by rings of cells.
//
// Computes:   whether the planes of the blocks around the receiver show that PCSS by angular diameter is 1 or 0 there;
//             else the visibility of a disc light, from every texel near the receiver and larger cells farther away.
// Source:     Penumbra's own: what Shaders/PenumbraCellPcss.compute does for tiles of pixels, for a receiver alone.
//             CellSums.hlsl; ReceiverDecision.hlsl.
// Inputs:     those of PcssAngular.hlsl, whose numbers of samples are not used; depthPlanes and depthSpreads of blocks
//             of 4 x 4 texels, and coarsePlanes and coarseSpreads of 8 x 8 texels, with mip levels: of the passes
//             QuarterDepthBlocks, EighthDepthBlocks and DepthBlocksMip, or of Cell PCSS's kernels FirstLevels and
//             NextLevel.
// Cost:       up to 9 fetches of the planes for each of up to kMostRingRadii radii; where those do not decide, some 20
//             gathers in search of blockers and about as many in the filter, and 12 and 20 for each octave of distance
//             beyond.
// Guarantees: [0, 1] for any input; no noise: the same receiver gives the same answer. Where the planes decide, it is
//             what FilterPcssAngular returns, to the last bit. Reads no texel outside of the receiver's tile that
//             counts.
// Use it:     in forward shaders and for what blends, where the renderer feature makes these maps. Not: for a whole
//             screen on devices with compute shaders, where tiles share what they read.
#ifndef PENUMBRA_CELL_FILTER_HLSL
#define PENUMBRA_CELL_FILTER_HLSL

#include "../../Core/FastLoop.hlsl"
#include "../Decisions/ReceiverDecision.hlsl"
#include "CellSums.hlsl"

// The spreads of the four cells of a level, from 1, that one block of the level above contains.
uint4 SpreadsOfLevel(Texture2D<uint4> depthSpreads, Texture2D<uint4> coarseSpreads, int2 block, int level)
{
    uint4 spreads;
    UNITY_BRANCH
    if (level == 1) spreads = LOAD_TEXTURE2D(depthSpreads, block);
    else spreads = LOAD_TEXTURE2D_LOD(coarseSpreads, block, level - 2);
    return spreads;
}

// The depths of four texels, from the texel `first` on, row by row.
float4 DepthsOfQuad(TEXTURE2D_PARAM(shadowMap, sampler_point), int2 first, QuadReceiver receiver)
{
    const float2 corner = float2(first + 1) * receiver.texelSize;
    return SanitizeMapDepth(GATHER_RED_TEXTURE2D(shadowMap, sampler_point, corner)).wzxy;
}

// The quads of each level that a thread sums: from the first, each step-th.
struct QuadShare
{
    int first;
    int step;
};

QuadShare AllQuads()
{
    QuadShare share;
    share.first = 0;
    share.step = 1;
    return share;
}

// Searches the texels of the first ring.
RingSearch SearchRingTexels(TEXTURE2D_PARAM(shadowMap, sampler_point), RingSearch found, QuadShare share, float radius,
                            QuadReceiver receiver, ConeScales scales)
{
    RingSearch search = found;
    const QuadRange quads = QuadsAround(receiver, 0, radius, kSearchRingCells);
    PENUMBRA_LOOP
    for (int i = share.first; i < CountOf(quads); i += share.step)
    {
        const int2 quad = QuadAt(quads, i);
        const float4 areas = AreasInRing(quad, 0, radius, kSearchRingCells, receiver);
        UNITY_BRANCH
        if (AnyArea(areas))
            search = SearchTexels(search, DepthsOfQuad(TEXTURE2D_ARGS(shadowMap, sampler_point), 2 * quad, receiver),
                                  quad, areas, receiver, scales);
    }
    return search;
}

// Searches the cells of the rings beyond, for which the search knows the ground.
RingSearch SearchRingCells(Texture2D<uint4> depthSpreads, Texture2D<uint4> coarseSpreads,
                           RingSearch found, QuadShare share, float radius, QuadReceiver receiver, ConeScales scales)
{
    RingSearch search = found;
    const int levels = RingLevels(radius, kSearchRingCells, kMostRingLevels);
    int level = 1;
    QuadRange quads = QuadsAround(receiver, level, radius, kSearchRingCells);
    int i = share.first;
    // One loop goes over the quads of all levels, because FXC compiles what is in a loop several times for each loop
    // around it.
    PENUMBRA_LOOP
    while (level <= levels)
    {
        UNITY_BRANCH
        if (i < CountOf(quads))
        {
            const int2 quad = QuadAt(quads, i);
            const float4 areas = AreasInRing(quad, level, radius, kSearchRingCells, receiver);
            UNITY_BRANCH
            if (AnyArea(areas))
                search = SearchCells(search, SpreadsOfLevel(depthSpreads, coarseSpreads, quad, level), quad, level,
                                     areas, receiver, scales);
            i += share.step;
        }
        else
        {
            ++level;
            quads = QuadsAround(receiver, level, radius, kSearchRingCells);
            i = share.first;
        }
    }
    return search;
}

// The lit and the blocked area of the disc's cells.
float2 SumRingDisc(TEXTURE2D_PARAM(shadowMap, sampler_point), Texture2D<uint4> depthSpreads,
                   Texture2D<uint4> coarseSpreads, RingPenumbra penumbra, QuadShare share, QuadReceiver receiver)
{
    float2 sums = float2(0.0, 0.0);
    const int level = DiscLevel(penumbra.radius, kRingCells);
    const QuadRange quads = QuadsAround(receiver, level, penumbra.radius, kRingCells);
    PENUMBRA_LOOP
    for (int i = share.first; i < CountOf(quads); i += share.step)
    {
        const int2 quad = QuadAt(quads, i);
        const float4 areas = AreasInDisc(quad, level, penumbra.radius, kRingCells, receiver);
        UNITY_BRANCH
        if (AnyArea(areas))
        {
            UNITY_BRANCH
            if (level == 0)
                sums = FilterTexels(sums, DepthsOfQuad(TEXTURE2D_ARGS(shadowMap, sampler_point), 2 * quad, receiver),
                                    quad, areas, penumbra, receiver);
            else
                sums = FilterCells(sums, SpreadsOfLevel(depthSpreads, coarseSpreads, quad, level), quad, level, areas,
                                   penumbra, receiver);
        }
    }
    return sums;
}

// The lit and the blocked weight of the 4 x 4 texels.
float2 SumRingBlock(TEXTURE2D_PARAM(shadowMap, sampler_point), RingPenumbra penumbra, QuadShare share,
                    QuadReceiver receiver)
{
    float2 sums = float2(0.0, 0.0);
    PENUMBRA_LOOP
    for (int k = share.first; k < 4; k += share.step)
    {
        const int2 first = QuadOfBlock(receiver, k);
        sums = FilterBlockQuad(sums, DepthsOfQuad(TEXTURE2D_ARGS(shadowMap, sampler_point), first, receiver), first,
                               penumbra, receiver);
    }
    return sums;
}

// No blocker's penumbra is wider than radius, texels.
float RingVisibility(TEXTURE2D_PARAM(shadowMap, sampler_point), Texture2D<uint4> depthSpreads,
                     Texture2D<uint4> coarseSpreads, float radius, QuadReceiver receiver, ConeScales scales)
{
    const RingSearch nearby = SearchRingTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), BeginSearch(scales),
                                               AllQuads(), radius, receiver, scales);
    const RingSearch search =
        SearchRingCells(depthSpreads, coarseSpreads, nearby, AllQuads(), radius, receiver, scales);
    const RingPenumbra penumbra = PenumbraOf(search, radius, scales);
    if (!penumbra.blocked) return 1.0;
    float visibility = 1.0;
    if (penumbra.readsBlock)
    {
        const float2 block = SumRingBlock(TEXTURE2D_ARGS(shadowMap, sampler_point), penumbra, AllQuads(), receiver);
        visibility = LitShare(block.x, block.y);
    }
    if (penumbra.readsDisc && visibility > 0.0)
    {
        const float2 disc = SumRingDisc(TEXTURE2D_ARGS(shadowMap, sampler_point), depthSpreads, coarseSpreads, penumbra,
                                        AllQuads(), receiver);
        visibility = min(visibility, LitShare(disc.x, disc.y));
    }
    return SanitizeVisibility(visibility);
}

float FilterDepthRings(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                       TEXTURE2D(depthPlanes), Texture2D<uint4> depthSpreads, TEXTURE2D(coarsePlanes),
                       Texture2D<uint4> coarseSpreads, ShadowReceiver receiver, ShadowTile tile,
                       PcssAngularParameters parameters)
{
    const RingReach reach = RingReachOf(receiver, tile, parameters);
    const RingDecision decision = DecideRings(depthPlanes, coarsePlanes, reach);
    if (decision.visibility >= 0.0) return decision.visibility;
    return RingVisibility(TEXTURE2D_ARGS(shadowMap, sampler_point), depthSpreads, coarseSpreads,
                          min(decision.radius, reach.cone.scales.largestRadius), reach.receiver, reach.cone.scales);
}

#endif
