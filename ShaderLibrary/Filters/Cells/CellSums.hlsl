// Penumbra: visibility of a disc light from every cell of the shadow map around a receiver, four cells at a time.
//
// Computes:   which quads of cells lie in the rings of a level; sums over a quad's cells in search of blockers, and in
//             the filter; the penumbra that the search finds, and what of the filter is needed for it.
// Source:     Penumbra's own; the filter is that of PcssAngular.hlsl over every cell of CellRings.hlsl in place of
//             samples.
// Inputs:     QuadReceiver; ConeScales; of each quad its four depths or packed spreads, row by row, from wherever they
//             are kept: textures (CellFilter.hlsl) or groupshared memory (ShaderLibrary/ScreenTiles/TileWindows.hlsl).
// Cost:       no fetches. Some 30 cells for each octave of distance in search of blockers, and 20 to 80 in the filter.
// Guarantees: finite sums. A cell that is not wholly in the receiver's tile does not count.
// Use it:     in a loop over the levels and, of each, over QuadsAround. Not: under spot lights.
#ifndef PENUMBRA_CELL_SUMS_HLSL
#define PENUMBRA_CELL_SUMS_HLSL

#include "../../Core/RowOrder.hlsl"
#include "CellRings.hlsl"
#include "../Pcss/PcssAngular.hlsl"

// There are so many levels of cells beyond the texels: the widest cells are of 256 texels.
static const int kMostRingLevels = 8;
// A narrow penumbra's kernel is wider than its radius, by the width of its texels. It is therefore made narrower by
// this many texels, and no narrower than that. From 0.75 to 1.25 texels the error in the sun's own penumbrae falls, and
// that over all pixels rises from 1 on; fitting a straight edge to the texels changes either by a hundredth.
static const float kKernelNarrowing = 0.25;
static const float kNarrowestRadius = 1.125;

// A range of quads of cells of one level; low and size are in quads.
struct QuadRange
{
    int2 low;
    int2 size;
};

// The k-th cell of a quad, row by row.
int2 CellOfQuad(int2 quad, int k)
{
    return 2 * quad + int2(k & 1, k >> 1);
}

// The way from the receiver to the centre of a cell of that width, texels.
float2 AwayFrom(QuadReceiver receiver, int2 cell, float width)
{
    return (float2(cell) + 0.5) * width - receiver.centre;
}

// The quads that hold all cells in the level's ring, and some without. A cell's share of the ring ends half a cell
// beyond the ring.
QuadRange QuadsAround(QuadReceiver receiver, int level, float radius, float ringCells)
{
    const float width = PowerOfTwo(level);
    const float reach = min(ringCells, radius / width);
    const float2 here = receiver.centre / width;
    const int2 low = int2(max(floor(here - reach), ceil(receiver.bounds.minimum / width)));
    const int2 high = int2(min(floor(here + reach), floor(receiver.bounds.maximum / width) - 1.0));
    QuadRange quads;
    quads.low = low >> 1;
    quads.size = max((high >> 1) - quads.low + 1, 0);
    return quads;
}

int CountOf(QuadRange quads)
{
    return quads.size.x * quads.size.y;
}

int2 QuadAt(QuadRange quads, int index)
{
    return quads.low + PlaceInRows(index, quads.size.x);
}

// The area of each cell that belongs to the level's ring or, if filled, to the ring and what it encloses, texels.
float4 AreasOfQuad(int2 quad, int level, float radius, float ringCells, bool filled, QuadReceiver receiver)
{
    const float width = PowerOfTwo(level);
    const float2 low = ceil(receiver.bounds.minimum / width);
    const float2 high = floor(receiver.bounds.maximum / width);
    float4 areas;
    UNITY_UNROLL
    for (int k = 0; k < 4; ++k)
    {
        const float2 cell = float2(CellOfQuad(quad, k));
        const float distance = length(AwayFrom(receiver, CellOfQuad(quad, k), width));
        const bool inTile = all(cell >= low) && all(cell < high);
        const float share = filled ? ShareInDisc(distance, level, radius, ringCells)
                                   : ShareInRing(distance, level, radius, ringCells);
        areas[k] = inTile ? share * width * width : 0.0;
    }
    return areas;
}

float4 AreasInRing(int2 quad, int level, float radius, float ringCells, QuadReceiver receiver)
{
    return AreasOfQuad(quad, level, radius, ringCells, false, receiver);
}

// The level of the filter's cells, of which filterCells or fewer reach to the edge of its disc. Smaller cells near the
// receiver, as the search has them, change the error by less than a hundredth.
int DiscLevel(float radius, float filterCells)
{
    return RingLevels(radius + 0.5, filterCells, kMostRingLevels);
}

// The area of each cell that belongs to the filter's disc. level is DiscLevel's.
float4 AreasInDisc(int2 quad, int level, float radius, float filterCells, QuadReceiver receiver)
{
    return AreasOfQuad(quad, level, radius, filterCells, true, receiver);
}

bool AnyArea(float4 areas)
{
    return max(max(areas.x, areas.y), max(areas.z, areas.w)) > 0.0;
}

struct RingSearch
{
    RingSums sums;
    float low;    // how much of the cone low blockers hide, texels
    float ground; // depth of the ground for BlockersOfCell; known after the texels
    bool groundFound;
};

RingSearch BeginSearch(ConeScales scales)
{
    RingSearch search;
    search.sums = NoBlockers();
    search.low = 0.0;
    search.ground = UsualGround(scales);
    search.groundFound = false;
    return search;
}

// depth is a texel's. area is what of the texel belongs to the first ring, above 0.
RingSearch SearchTexel(RingSearch search, float depth, float2 away, float area, QuadReceiver receiver,
                       ConeScales scales)
{
    RingSearch next = search;
    const float distance = length(away);
    if (distance < kGroundReach)
        next.ground = GroundWithTexel(next.ground, next.groundFound, depth, away, receiver, scales);
    const CellBlockers blockers = BlockersOfTexel(depth, away, receiver);
    if (!(blockers.share > 0.0)) return next;
    next.sums = AddBlockers(next.sums, blockers, distance, 1.0, area, scales);
    const bool isLow = blockers.gap < kLowBlockerTexels * scales.depthPerTexel;
    if (isLow && next.sums.inside.x > search.sums.inside.x) next.low += area;
    return next;
}

// depths are those of a quad of texels. areas are AreasInRing's of level 0.
RingSearch SearchTexels(RingSearch search, float4 depths, int2 quad, float4 areas, QuadReceiver receiver,
                        ConeScales scales)
{
    RingSearch next = search;
    UNITY_UNROLL
    for (int k = 0; k < 4; ++k)
    {
        const float2 away = AwayFrom(receiver, CellOfQuad(quad, k), 1.0);
        UNITY_BRANCH
        if (areas[k] > 0.0) next = SearchTexel(next, depths[k], away, areas[k], receiver, scales);
    }
    return next;
}

// cells holds the packed spreads of a quad of cells of that level, from 1.
RingSearch SearchCells(RingSearch search, uint4 cells, int2 quad, int level, float4 areas, QuadReceiver receiver,
                       ConeScales scales)
{
    RingSearch next = search;
    const float width = PowerOfTwo(level);
    UNITY_UNROLL
    for (int k = 0; k < 4; ++k)
    {
        UNITY_BRANCH
        if (areas[k] > 0.0)
        {
            const float2 away = AwayFrom(receiver, CellOfQuad(quad, k), width);
            const CellBlockers blockers = BlockersOfCell(UnpackSpread(cells[k]), away, width, search.ground, receiver);
            if (blockers.share > 0.0)
                next.sums = AddBlockers(next.sums, blockers, length(away), width, areas[k], scales);
        }
    }
    return next;
}

// The penumbra that the search has found, and the filter that follows, over the 4 x 4 texels around the receiver, over
// a disc, or over both.
struct RingPenumbra
{
    bool blocked;         // false: the receiver is lit
    bool readsBlock;
    bool readsDisc;
    float radius;         // texels
    float blockRadius;    // texels
    float blockGap;       // stored depth: texels from that gap up have no weight in the block
    float ground;
    LightCone cone;       // its slack is that of the disc
};

// radius is the search's.
RingPenumbra PenumbraOf(RingSearch search, float radius, ConeScales scales)
{
    const RingSums sums = search.sums;
    const bool inside = sums.inside.x > 0.0;
    const float2 found = inside ? sums.inside : sums.nearby;
    RingPenumbra penumbra;
    penumbra.blocked = sums.nearby.x > 0.0;
    penumbra.radius = penumbra.blocked ? min(found.y / found.x, radius) : 0.0;
    const float gap = penumbra.radius * scales.depthPerTexel;
    const bool narrow = penumbra.radius <= kWidestBlockTexels;
    penumbra.readsBlock = narrow || search.low > 0.0;
    penumbra.readsDisc = !narrow;
    penumbra.blockRadius = min(max(penumbra.radius - kKernelNarrowing, kNarrowestRadius), kWidestBlockTexels);
    penumbra.blockGap = narrow ? kAnyGap : min(kLowBlockerTexels * scales.depthPerTexel, kLowBlockerShare * gap);
    penumbra.ground = search.ground;
    penumbra.cone.scales = scales;
    penumbra.cone.slackTexels = kQuadSlackTexels;
    penumbra.cone.largestOffset = inside ? kConeHeightShare * gap : kAnyGap;
    return penumbra;
}

// The k-th quad of texels of the 4 x 4 around the receiver; its first texel.
int2 QuadOfBlock(QuadReceiver receiver, int k)
{
    return int2(floor(receiver.centre + 0.5)) - 2 + 2 * int2(k & 1, k >> 1);
}

// Adds one texel of the block to the lit and the blocked weight, as FilterBlock of PcssAngular.hlsl weighs it.
float2 FilterBlockTexel(float2 sums, float depth, int2 texel, RingPenumbra penumbra, QuadReceiver receiver)
{
    const float outermost = max(penumbra.blockRadius + kBlockReachTexels, kSmallestBlockTexels);
    const float slack = kWidestBlockTexels + kBlockReachTexels;
    const float2 away = AwayFrom(receiver, texel, 1.0);
    const float distance = length(away);
    const bool inTile = all(float2(texel) >= receiver.bounds.minimum) && all(float2(texel) < receiver.bounds.maximum);
    const CellBlockers blockers = BlockersOfTexel(depth, away, receiver);
    const float weight = inTile && blockers.gap < penumbra.blockGap ? max(1.0 - distance / outermost, 0.0) : 0.0;
    const float offset = ConeOffset(distance, slack, penumbra.cone.largestOffset, penumbra.cone.scales);
    const float hidden = blockers.gap > offset ? blockers.share * weight : 0.0;
    return sums + float2(weight - hidden, hidden);
}

// Adds a quad of the block to the weights. first is QuadOfBlock's.
float2 FilterBlockQuad(float2 sums, float4 depths, int2 first, RingPenumbra penumbra, QuadReceiver receiver)
{
    float2 next = sums;
    UNITY_UNROLL
    for (int k = 0; k < 4; ++k)
        next = FilterBlockTexel(next, depths[k], first + int2(k & 1, k >> 1), penumbra, receiver);
    return next;
}

// Adds one cell to the lit and the blocked area.
float2 FilterCell(float2 sums, CellBlockers blockers, float distance, float width, float area, LightCone cone)
{
    const float cut = ConeOffset(distance, max(cone.slackTexels, width), cone.largestOffset, cone.scales);
    const float hidden = blockers.gap > cut ? blockers.share * area : 0.0;
    return sums + float2(area - hidden, hidden);
}

// Adds a quad of texels to the areas, as FilterDisc of PcssAngular.hlsl weighs them. areas are AreasInDisc's of level
// 0.
float2 FilterTexels(float2 sums, float4 depths, int2 quad, float4 areas, RingPenumbra penumbra, QuadReceiver receiver)
{
    float2 next = sums;
    UNITY_UNROLL
    for (int k = 0; k < 4; ++k)
    {
        UNITY_BRANCH
        if (areas[k] > 0.0)
        {
            const float2 away = AwayFrom(receiver, CellOfQuad(quad, k), 1.0);
            next = FilterCell(next, BlockersOfTexel(depths[k], away, receiver), length(away), 1.0, areas[k],
                              penumbra.cone);
        }
    }
    return next;
}

// Adds a quad of larger cells to the areas.
float2 FilterCells(float2 sums, uint4 cells, int2 quad, int level, float4 areas, RingPenumbra penumbra,
                   QuadReceiver receiver)
{
    float2 next = sums;
    const float width = PowerOfTwo(level);
    UNITY_UNROLL
    for (int k = 0; k < 4; ++k)
    {
        UNITY_BRANCH
        if (areas[k] > 0.0)
        {
            const float2 away = AwayFrom(receiver, CellOfQuad(quad, k), width);
            const CellBlockers blockers = BlockersOfCell(UnpackSpread(cells[k]), away, width, penumbra.ground,
                                                         receiver);
            next = FilterCell(next, blockers, length(away), width, areas[k], penumbra.cone);
        }
    }
    return next;
}

#endif
