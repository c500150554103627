// Penumbra: the shadow map around a tile's receivers in groupshared memory, and what it says of each of them.
//
// Computes:   windows of texels and of larger cells around a cluster of receivers; the visibility of each, from them alone.
// Source:     Penumbra's own; the filter is that of Filters/PcssAngular.hlsl over every cell of Filters/DepthRings.hlsl in place
//             of samples.
// Inputs:     the shadow map; spreads and coarseSpreads, of the kernels FirstLevels and NextLevel, four cells in each texel;
//             TileClusters.hlsl.
// Cost:       a gather for each 2 x 2 texels of the first window, a fetch for each 2 x 2 cells of the others, shared by the
//             cluster. Arithmetic: some 30 cells for each octave of distance in search of blockers, and 60 in the filter;
//             19 KiB of groupshared memory.
// Guarantees: [0, 1]; no noise: the same map gives the same picture. Reads no texel outside of the receivers' tile.
// Use it:     in kernels of 16 x 16 threads, all of which call the functions that load.
#ifndef PENUMBRA_TILE_WINDOWS_HLSL
#define PENUMBRA_TILE_WINDOWS_HLSL

#include "TileClusters.hlsl"
#include "../ShaderLibrary/Filters/DepthRings.hlsl"

// Texels of the first window each way; and cells of all others together: the n-th is at most 2 kWindowReach / 2^n +
// 2 kRingCells + 5 wide.
#define WINDOW_TEXELS 40
#define WINDOW_CELLS 2650
#define MOST_LEVELS 8

// The kernel of narrow penumbrae is wider than its radius by its texels: so much narrower it is made, and no narrower than
// that. From 0.75 to 1.25 texels the error in the sun's own penumbrae falls, and that over all pixels rises from 1 on; fitting a
// straight edge to the texels changes either by a hundredth.
static const float kKernelNarrowing = 0.25;
static const float kNarrowestRadius = 1.125;
// How far from the cluster's first receiver, texels along each axis, a receiver may lie.
static const float kWindowReach = 0.5 * (float(WINDOW_TEXELS) - 3.0) - kRingCells - 1.0;

groupshared float windowDepths[WINDOW_TEXELS * WINDOW_TEXELS];
groupshared uint windowSpreads[WINDOW_CELLS];

// Receivers, in whole texels, and how far around them the windows reach.
struct WindowBounds
{
    int2 low;
    int2 high;
    float radius; // texels
    int levels;   // beyond the texels
    TileBounds tile;
};

struct DepthWindow
{
    int2 low;  // first cell
    int2 size; // cells
};

DepthWindow WindowOf(WindowBounds bounds, int level)
{
    const float cell = exp2(float(level));
    const float reach = min(kRingCells * cell, bounds.radius) + cell;
    const int2 low = int2(floor((float2(bounds.low) - reach) / cell));
    const int2 high = int2(floor((float2(bounds.high) + 1.0 + reach) / cell));
    DepthWindow window;
    window.low = max(low, int2(bounds.tile.minimum / cell));
    window.size = max(min(high, int2(bounds.tile.maximum / cell) - 1) - window.low + 1, 0);
    return window;
}

WindowBounds BoundWindow(bool joins, QuadReceiver receiver, float radius)
{
    BoundCluster(joins, receiver);
    if (joins) InterlockedMax(clusterRadius, asuint(radius));
    GroupMemoryBarrierWithGroupSync();
    WindowBounds bounds;
    bounds.low = int2(clusterLeft, clusterTop);
    bounds.high = int2(clusterRight, clusterBottom);
    bounds.radius = asfloat(clusterRadius);
    bounds.levels = RingLevels(bounds.radius, kSearchRingCells, MOST_LEVELS);
    bounds.tile = BoundsInTexels(clusterTile);
    return bounds;
}

// Threads of a group that nobody joined read nothing.
void LoadWindows(TEXTURE2D_PARAM(shadowMap, sampler_point), TYPED_TEXTURE2D(uint4, spreads),
                 TYPED_TEXTURE2D(uint4, coarseSpreads), WindowBounds bounds, uint thread)
{
    const bool any = bounds.high.x >= bounds.low.x;
    const DepthWindow texels = WindowOf(bounds, 0);
    const int2 begin = texels.low - (texels.low & 1);
    const int2 quads = any ? (texels.low + texels.size - begin + 1) / 2 : int2(0, 0);
    int i;
    UNITY_LOOP
    for (i = int(thread); i < quads.x * quads.y; i += TILE_THREADS)
    {
        const int2 first = begin + 2 * int2(i % quads.x, i / quads.x);
        const float2 uv = float2(first + 1) * clusterTexelSize;
        const float4 depths = SanitizeMapDepth(GATHER_RED_TEXTURE2D(shadowMap, sampler_point, uv));
        UNITY_UNROLL
        for (int k = 0; k < 4; ++k)
        {
            const int2 at = first + GatheredTexel(k) - texels.low;
            if (all(at >= 0) && all(at < texels.size)) windowDepths[at.y * texels.size.x + at.x] = depths[k];
        }
    }
    int offset = 0;
    UNITY_LOOP
    for (int level = 1; level <= bounds.levels; ++level)
    {
        const DepthWindow window = WindowOf(bounds, level);
        const int2 firstBlock = window.low >> 1;
        const int2 blocks = any ? ((window.low + window.size + 1) >> 1) - firstBlock : int2(0, 0);
        UNITY_LOOP
        for (i = int(thread); i < blocks.x * blocks.y; i += TILE_THREADS)
        {
            const int2 block = firstBlock + int2(i % blocks.x, i / blocks.x);
            uint4 cells;
            if (level == 1) cells = LOAD_TEXTURE2D(spreads, block);
            else cells = LOAD_TEXTURE2D_LOD(coarseSpreads, block, level - 2);
            UNITY_UNROLL
            for (int k = 0; k < 4; ++k)
            {
                const int2 at = 2 * block + int2(k & 1, k >> 1) - window.low;
                const int place = offset + at.y * window.size.x + at.x;
                if (all(at >= 0) && all(at < window.size) && place < WINDOW_CELLS) windowSpreads[place] = cells[k];
            }
        }
        offset += window.size.x * window.size.y;
    }
    GroupMemoryBarrierWithGroupSync();
}

float DepthInWindow(DepthWindow texels, int2 texel)
{
    const int2 at = texel - texels.low;
    return windowDepths[at.y * texels.size.x + at.x];
}

CellBlockers BlockersInWindow(DepthWindow window, int offset, int level, int2 cell, float2 away, float ground,
                              QuadReceiver receiver)
{
    if (level == 0) return BlockersOfTexel(DepthInWindow(window, cell), away, receiver);
    const int2 at = cell - window.low;
    const DepthSpread spread = UnpackSpread(windowSpreads[min(offset + at.y * window.size.x + at.x, WINDOW_CELLS - 1)]);
    return BlockersOfCell(spread, away, exp2(float(level)), ground, receiver);
}

// Cells of a level around a receiver, up to `radius` texels from it.
struct CellLoop
{
    int2 low;
    int2 size;
};

CellLoop CellsAround(QuadReceiver receiver, DepthWindow window, int level, float radius, float ringCells)
{
    const float cell = exp2(float(level));
    const int reach = int(ceil(min(ringCells, radius / cell) + 0.5));
    const int2 here = int2(floor(receiver.centre / cell));
    CellLoop cells;
    cells.low = max(here - reach, window.low);
    cells.size = max(min(here + reach, window.low + window.size - 1) - cells.low + 1, 0);
    return cells;
}

struct WindowSearch
{
    RingSums sums;
    float low;    // how much of the cone low blockers hide, texels
    float ground; // BlockersOfCell
};

WindowSearch SumBlockers(QuadReceiver receiver, ConeScales scales, float radius, WindowBounds bounds)
{
    WindowSearch search;
    search.sums = NoBlockers();
    search.low = 0.0;
    search.ground = UsualGround(scales);
    bool groundFound = false;
    int offset = 0;
    const int levels = min(RingLevels(radius, kSearchRingCells, MOST_LEVELS), bounds.levels);
    UNITY_LOOP
    for (int level = 0; level <= levels; ++level)
    {
        const DepthWindow window = WindowOf(bounds, level);
        const CellLoop cells = CellsAround(receiver, window, level, radius, kSearchRingCells);
        const float width = exp2(float(level));
        UNITY_LOOP
        for (int i = 0; i < cells.size.x * cells.size.y; ++i)
        {
            const int2 cell = cells.low + int2(i % cells.size.x, i / cells.size.x);
            const float2 away = (float2(cell) + 0.5) * width - receiver.centre;
            const float distance = length(away);
            const float area = ShareInRing(distance, level, radius, kSearchRingCells) * width * width;
            if (!(area > 0.0)) continue;
            if (level == 0 && distance < kGroundReach)
                search.ground = GroundWithTexel(search.ground, groundFound, DepthInWindow(window, cell), away, receiver, scales);
            const CellBlockers blockers = BlockersInWindow(window, offset, level, cell, away, search.ground, receiver);
            if (!(blockers.share > 0.0)) continue;
            const float before = search.sums.inside.x;
            search.sums = AddBlockers(search.sums, blockers, distance, width, area, scales);
            const bool isLow = level == 0 && blockers.gap < kLowBlockerTexels * scales.depthPerTexel;
            if (isLow && search.sums.inside.x > before) search.low += area;
        }
        if (level > 0) offset += window.size.x * window.size.y;
    }
    return search;
}

// As FilterBlock of PcssAngular.hlsl, over the window.
float FilterWindowBlock(QuadReceiver receiver, LightCone cone, float radius, float largestGap, DepthWindow window)
{
    const int2 first = int2(floor(receiver.centre + 0.5)) - 2;
    const float outermost = max(radius + kBlockReachTexels, kSmallestBlockTexels);
    float lit = 0.0;
    float blocked = 0.0;
    UNITY_LOOP
    for (int i = 0; i < 16; ++i)
    {
        const int2 texel = first + int2(i & 3, i >> 2);
        const int2 at = texel - window.low;
        if (any(at < 0) || any(at >= window.size)) continue;
        const float2 away = float2(texel) + 0.5 - receiver.centre;
        const float distance = length(away);
        const CellBlockers blockers = BlockersOfTexel(DepthInWindow(window, texel), away, receiver);
        const float weight = blockers.gap < largestGap ? max(1.0 - distance / outermost, 0.0) : 0.0;
        const float offset = ConeOffset(distance, cone.slackTexels, cone.largestOffset, cone.scales);
        const float hidden = blockers.gap > offset ? blockers.share * weight : 0.0;
        blocked += hidden;
        lit += weight - hidden;
    }
    return LitShare(lit, blocked);
}

// As FilterDisc, over every cell of the disc.
float FilterWindowDisc(QuadReceiver receiver, LightCone cone, float radius, float ground, WindowBounds bounds)
{
    float lit = 0.0;
    float blocked = 0.0;
    int offset = 0;
    const int levels = min(RingLevels(radius + 0.5, kRingCells, MOST_LEVELS), bounds.levels);
    UNITY_LOOP
    for (int level = 0; level <= levels; ++level)
    {
        const DepthWindow window = WindowOf(bounds, level);
        const CellLoop cells = CellsAround(receiver, window, level, radius, kRingCells);
        const float width = exp2(float(level));
        UNITY_LOOP
        for (int i = 0; i < cells.size.x * cells.size.y; ++i)
        {
            const int2 cell = cells.low + int2(i % cells.size.x, i / cells.size.x);
            const float2 away = (float2(cell) + 0.5) * width - receiver.centre;
            const float distance = length(away);
            const float weight = ShareInRing(distance, level, radius, kRingCells) * width * width;
            if (!(weight > 0.0)) continue;
            const CellBlockers blockers = BlockersInWindow(window, offset, level, cell, away, ground, receiver);
            const float cut = ConeOffset(distance, max(cone.slackTexels, width), cone.largestOffset, cone.scales);
            const float hidden = blockers.gap > cut ? blockers.share * weight : 0.0;
            blocked += hidden;
            lit += weight - hidden;
        }
        if (level > 0) offset += window.size.x * window.size.y;
    }
    return LitShare(lit, blocked);
}

float WindowVisibility(QuadReceiver receiver, ConeScales scales, float radius, WindowBounds bounds)
{
    const WindowSearch search = SumBlockers(receiver, scales, radius, bounds);
    const RingSums sums = search.sums;
    if (!(sums.nearby.x > 0.0)) return 1.0;
    const bool inside = sums.inside.x > 0.0;
    const float penumbra = min(inside ? sums.inside.y / sums.inside.x : sums.nearby.y / sums.nearby.x, radius);
    const float gap = penumbra * scales.depthPerTexel;
    LightCone cone;
    cone.scales = scales;
    cone.largestOffset = inside ? kConeHeightShare * gap : kAnyGap;
    const bool narrow = penumbra <= kWidestBlockTexels;
    float visibility = 1.0;
    if (narrow || search.low > 0.0)
    {
        cone.slackTexels = kWidestBlockTexels + kBlockReachTexels;
        const float lowGap = min(kLowBlockerTexels * scales.depthPerTexel, kLowBlockerShare * gap);
        visibility = FilterWindowBlock(receiver, cone, min(max(penumbra - kKernelNarrowing, kNarrowestRadius), kWidestBlockTexels),
                                       narrow ? kAnyGap : lowGap, WindowOf(bounds, 0));
    }
    if (!narrow && visibility > 0.0)
    {
        cone.slackTexels = kQuadSlackTexels;
        visibility = min(visibility, FilterWindowDisc(receiver, cone, penumbra, search.ground, bounds));
    }
    return SanitizeVisibility(visibility);
}

#endif
