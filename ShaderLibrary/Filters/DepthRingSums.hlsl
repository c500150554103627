// Penumbra: visibility of a disc light from every cell of the shadow map around a receiver, four cells at a time.
//
// Computes:   which quads of cells lie in the rings of a level; sums over a quad's cells in search of blockers, and in the
//             filter; the penumbra that the search finds, and what of the filter is needed for it.
// Source:     Penumbra's own; the filter is that of PcssAngular.hlsl over every cell of DepthRings.hlsl in place of samples.
// Inputs:     QuadReceiver; ConeScales; of each quad its four depths or packed spreads, row by row, from wherever they are
//             kept: textures (DepthRingFilter.hlsl) or groupshared memory (Shaders/TileWindows.hlsl).
// Cost:       no fetches. Some 30 cells for each octave of distance in search of blockers, and 20 to 80 in the filter.
// Guarantees: finite sums. A cell that is not wholly in the receiver's tile does not count.
// Use it:     in a loop over the levels and, of each, over QuadsAround. Not: under spot lights.
#ifndef PENUMBRA_DEPTH_RING_SUMS_HLSL
#define PENUMBRA_DEPTH_RING_SUMS_HLSL

#include "../Core/RowOrder.hlsl"
#include "DepthRings.hlsl"
#include "PcssAngular.hlsl"

// Levels of cells beyond the texels: the widest cells are of 256 texels.
static const int kMostRingLevels = 8;
// The kernel of narrow penumbrae is wider than its radius by its texels: so much narrower it is made, and no narrower than
// that. From 0.75 to 1.25 texels the error in the sun's own penumbrae falls, and that over all pixels rises from 1 on; fitting a
// straight edge to the texels changes either by a hundredth.
static const float kKernelNarrowing = 0.25;
static const float kNarrowestRadius = 1.125;

// Quads of cells of one level.
struct QuadRange
{
    int2 low;  // first cell of the first
    int2 size; // quads
};

// The k-th cell of a quad, row by row. first: of its cells.
int2 CellOfQuad(int2 first, int k)
{
    return first + int2(k & 1, k >> 1);
}

// From the receiver to a cell's centre, texels. width: of the cell.
float2 AwayFrom(QuadReceiver receiver, int2 cell, float width)
{
    return (float2(cell) + 0.5) * width - receiver.centre;
}

// All quads with cells in the level's ring, and some without. A cell's share of the ring ends half a cell beyond the ring.
QuadRange QuadsAround(QuadReceiver receiver, int level, float radius, float ringCells)
{
    const float width = PowerOfTwo(level);
    const float reach = min(ringCells, radius / width);
    const float2 here = receiver.centre / width;
    const int2 low = int2(max(floor(here - reach), ceil(receiver.bounds.minimum / width)));
    const int2 high = int2(min(floor(here + reach), floor(receiver.bounds.maximum / width) - 1.0));
    QuadRange quads;
    quads.low = low & ~1;
    quads.size = max((high >> 1) - (low >> 1) + 1, 0);
    return quads;
}

int CountOf(QuadRange quads)
{
    return quads.size.x * quads.size.y;
}

// Its first cell.
int2 QuadAt(QuadRange quads, int index)
{
    return quads.low + 2 * PlaceInRows(index, quads.size.x);
}

// The level of the filter's cells, filterCells or fewer to the edge of its disc. Smaller cells near the receiver, as the search
// has them, change the error by less than a hundredth.
int DiscLevel(float radius, float filterCells)
{
    return RingLevels(radius + 0.5, filterCells, kMostRingLevels);
}

struct RingSearch
{
    RingSums sums;
    float low;    // how much of the cone low blockers hide, texels
    float ground; // BlockersOfCell; known after the texels
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

// area: what of the cell belongs to its ring, above 0.
RingSearch SearchCell(RingSearch search, CellBlockers blockers, float distance, float width, float area, ConeScales scales)
{
    RingSearch next = search;
    if (blockers.share > 0.0)
    {
        next.sums = AddBlockers(search.sums, blockers, distance, width, area, scales);
        const bool isLow = width == 1.0 && blockers.gap < kLowBlockerTexels * scales.depthPerTexel;
        if (isLow && next.sums.inside.x > search.sums.inside.x) next.low += area;
    }
    return next;
}

// With a texel of the first ring, where it may be the ground. distance: length(away).
RingSearch SearchGround(RingSearch search, float depth, float2 away, float distance, QuadReceiver receiver, ConeScales scales)
{
    RingSearch next = search;
    if (distance < kGroundReach)
        next.ground = GroundWithTexel(next.ground, next.groundFound, depth, away, receiver, scales);
    return next;
}

// What the search has found, and the filter that follows: over the 4 x 4 texels around the receiver, over a disc, or both.
struct RingPenumbra
{
    bool blocked;         // else the receiver is lit
    bool readsBlock;
    bool readsDisc;
    float radius;         // texels
    float blockRadius;    // texels
    float blockGap;       // stored depth: texels from that gap up have no weight in the block
    float ground;
    LightCone cone;       // its slack is that of the disc
};

// radius: of the search.
RingPenumbra PenumbraOf(RingSearch search, float radius, ConeScales scales)
{
    const RingSums sums = search.sums;
    const bool inside = sums.inside.x > 0.0;
    const float2 found = inside ? sums.inside : sums.nearby;
    RingPenumbra penumbra;
    penumbra.blocked = sums.nearby.x > 0.0;
    penumbra.radius = penumbra.blocked ? min(found.y / (penumbra.blocked ? found.x : 1.0), radius) : 0.0;
    const float gap = penumbra.radius * scales.depthPerTexel;
    const bool narrow = penumbra.radius <= kWidestBlockTexels;
    penumbra.readsBlock = penumbra.blocked && (narrow || search.low > 0.0);
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

// The weight of a texel of the block, as in FilterBlock of PcssAngular.hlsl.
float ShareInBlock(float distance, RingPenumbra penumbra)
{
    return max(1.0 - distance / max(penumbra.blockRadius + kBlockReachTexels, kSmallestBlockTexels), 0.0);
}

// The cone of the light for the block.
LightCone ConeOfBlock(RingPenumbra penumbra)
{
    LightCone cone = penumbra.cone;
    cone.slackTexels = kWidestBlockTexels + kBlockReachTexels;
    return cone;
}

// Lit and blocked areas, with those of one cell.
float2 FilterCell(float2 sums, CellBlockers blockers, float distance, float width, float area, LightCone cone)
{
    const float cut = ConeOffset(distance, max(cone.slackTexels, width), cone.largestOffset, cone.scales);
    const float hidden = blockers.gap > cut ? blockers.share * area : 0.0;
    return sums + float2(area - hidden, hidden);
}

// A receiver's visibility is found in stages, each of which sums over quads of cells. One function does all of them: FXC compiles
// a function anew for each call, and what is in a loop several times for each loop around it, so that four functions with loops
// of their own, called from a loop, take it half a minute.
#define RING_STAGES 4
static const int kTexelStage = 0; // searches the texels of the first ring
static const int kCellStage = 1;  // and the cells of the rings beyond, for which the texels have shown the ground
static const int kBlockStage = 2; // filters the 4 x 4 texels
static const int kDiscStage = 3;  // and the disc

struct RingState
{
    RingSearch search;
    float2 filtered;  // lit and blocked, of the stage
    float visibility; // of the stages that are over
};

RingState BeginRings(ConeScales scales)
{
    RingState state;
    state.search = BeginSearch(scales);
    state.filtered = float2(0.0, 0.0);
    state.visibility = 1.0;
    return state;
}

// What a stage sums.
struct RingStage
{
    int index;
    int2 levels; // first and last
    float radius;
    float ringCells;
    RingPenumbra penumbra; // of the stages that filter
};

// radius: of the search, texels. A stage that is not needed has no levels.
RingStage StageOf(int index, float radius, RingState state, ConeScales scales)
{
    const bool filters = index > kCellStage;
    RingStage stage;
    stage.index = index;
    stage.penumbra = PenumbraOf(state.search, radius, scales);
    stage.radius = filters ? stage.penumbra.radius : radius;
    stage.ringCells = filters ? kRingCells : kSearchRingCells;
    stage.levels = int2(0, 0);
    if (index == kCellStage) stage.levels = int2(1, RingLevels(radius, kSearchRingCells, kMostRingLevels));
    if (index == kBlockStage && !stage.penumbra.readsBlock) stage.levels.y = -1;
    if (index == kDiscStage)
    {
        const int level = DiscLevel(stage.radius, kRingCells);
        stage.levels = int2(level, stage.penumbra.readsDisc && state.visibility > 0.0 ? level : -1);
    }
    return stage;
}

// What of a cell's area counts, texels. distance: of its centre.
float AreaOfCell(float distance, int level, RingStage stage)
{
    const float width = PowerOfTwo(level);
    float share = stage.index > kCellStage ? ShareInDisc(distance, level, stage.radius, stage.ringCells)
                                           : ShareInRing(distance, level, stage.radius, stage.ringCells);
    if (stage.index == kBlockStage) share = ShareInBlock(distance, stage.penumbra);
    return share * width * width;
}

// With a cell of a stage. cell: bits of the depth of a texel, or a packed spread. area: above 0.
RingState AddCell(RingState state, RingStage stage, uint cell, float2 away, int level, float area, QuadReceiver receiver,
                  ConeScales scales)
{
    RingState next = state;
    const float width = PowerOfTwo(level);
    const float distance = length(away);
    CellBlockers blockers;
    UNITY_BRANCH
    if (level > 0) blockers = BlockersOfCell(UnpackSpread(cell), away, width, state.search.ground, receiver);
    else blockers = BlockersOfTexel(asfloat(cell), away, receiver);
    UNITY_BRANCH
    if (stage.index > kCellStage)
    {
        LightCone cone = stage.penumbra.cone;
        if (stage.index == kBlockStage) cone = ConeOfBlock(stage.penumbra);
        const bool counts = stage.index != kBlockStage || blockers.gap < stage.penumbra.blockGap;
        next.filtered = FilterCell(state.filtered, blockers, distance, width, counts ? area : 0.0, cone);
    }
    else
    {
        if (level == 0) next.search = SearchGround(state.search, asfloat(cell), away, distance, receiver, scales);
        next.search = SearchCell(next.search, blockers, distance, width, area, scales);
    }
    return next;
}

// After all shares of a stage.
RingState EndStage(RingState summed, int stage)
{
    RingState state = summed;
    if (stage > kCellStage) state.visibility = min(summed.visibility, LitShare(summed.filtered.x, summed.filtered.y));
    state.filtered = float2(0.0, 0.0);
    return state;
}

#endif
