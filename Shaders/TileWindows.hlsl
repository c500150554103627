// Penumbra: the shadow map around a tile's receivers in groupshared memory, and what it says of each of them.
//
// Computes:   windows of texels and of larger cells around a cluster of receivers; the visibility of each, from them alone.
// Source:     Penumbra's own; the filter is that of Filters/DepthRingFilter.hlsl, from groupshared memory.
// Inputs:     the shadow map; spreads and coarseSpreads, of the kernels FirstLevels and NextLevel, four cells in each texel;
//             TileClusters.hlsl.
// Cost:       a gather for each 2 x 2 texels of the first window, a fetch for each 2 x 2 cells of the others, shared by the
//             cluster. Arithmetic: that of Filters/DepthRingSums.hlsl; 19 KiB of groupshared memory.
// Guarantees: [0, 1]; no noise: the same map gives the same picture. Reads no texel outside of the receivers' tile.
// Use it:     in kernels of 16 x 16 threads, all of which call the functions that load.
#ifndef PENUMBRA_TILE_WINDOWS_HLSL
#define PENUMBRA_TILE_WINDOWS_HLSL

#include "TileClusters.hlsl"
#include "../ShaderLibrary/Filters/DepthRingSums.hlsl"

// Texels of the first window each way; and cells of all others together: the n-th is at most 2 kWindowReach / 2^n +
// 2 kRingCells + 5 wide.
#define WINDOW_TEXELS 40
#define WINDOW_CELLS 2650

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
    bounds.levels = RingLevels(bounds.radius, kSearchRingCells, kMostRingLevels);
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

// The texels of a quad that have an area, which lie in the window.
float4 DepthsInWindow(DepthWindow texels, int2 quad, float4 areas)
{
    float4 depths;
    UNITY_UNROLL
    for (int k = 0; k < 4; ++k)
    {
        const int2 at = CellOfQuad(quad, k) - texels.low;
        depths[k] = areas[k] > 0.0 ? windowDepths[at.y * texels.size.x + at.x] : 0.0;
    }
    return depths;
}

// offset: of the level's window among the others.
uint4 CellsInWindow(DepthWindow window, int offset, int2 quad, float4 areas)
{
    uint4 cells;
    UNITY_UNROLL
    for (int k = 0; k < 4; ++k)
    {
        const int2 at = CellOfQuad(quad, k) - window.low;
        cells[k] = areas[k] > 0.0 ? windowSpreads[min(offset + at.y * window.size.x + at.x, WINDOW_CELLS - 1)] : 0;
    }
    return cells;
}

RingSearch SearchWindow(QuadReceiver receiver, ConeScales scales, float radius, WindowBounds bounds)
{
    RingSearch search = BeginSearch(scales);
    int offset = 0;
    const int levels = min(RingLevels(radius, kSearchRingCells, kMostRingLevels), bounds.levels);
    UNITY_LOOP
    for (int level = 0; level <= levels; ++level)
    {
        const DepthWindow window = WindowOf(bounds, level);
        const QuadRange quads = QuadsAround(receiver, level, radius, kSearchRingCells);
        UNITY_LOOP
        for (int i = 0; i < CountOf(quads); ++i)
        {
            const int2 quad = QuadAt(quads, i);
            const float4 areas = AreasInRing(quad, level, radius, kSearchRingCells, receiver);
            if (!AnyArea(areas)) continue;
            if (level == 0)
                search = SearchTexels(search, DepthsInWindow(window, quad, areas), quad, areas, receiver, scales);
            else
                search = SearchCells(search, CellsInWindow(window, offset, quad, areas), quad, level, areas, receiver, scales);
        }
        if (level > 0) offset += window.size.x * window.size.y;
    }
    return search;
}

float FilterWindowBlock(RingPenumbra penumbra, QuadReceiver receiver, DepthWindow window)
{
    float2 sums = float2(0.0, 0.0);
    UNITY_LOOP
    for (int k = 0; k < 4; ++k)
    {
        const int2 first = QuadOfBlock(receiver, k);
        float4 depths;
        UNITY_UNROLL
        for (int i = 0; i < 4; ++i)
        {
            const int2 at = first + int2(i & 1, i >> 1) - window.low;
            const bool inside = all(at >= 0) && all(at < window.size);
            depths[i] = inside ? windowDepths[at.y * window.size.x + at.x] : 0.0;
        }
        sums = FilterBlockQuad(sums, depths, first, penumbra, receiver);
    }
    return LitShare(sums.x, sums.y);
}

float FilterWindowRings(RingPenumbra penumbra, QuadReceiver receiver, WindowBounds bounds)
{
    float2 sums = float2(0.0, 0.0);
    int offset = 0;
    const int levels = min(RingLevels(penumbra.radius + 0.5, kRingCells, kMostRingLevels), bounds.levels);
    UNITY_LOOP
    for (int level = 0; level <= levels; ++level)
    {
        const DepthWindow window = WindowOf(bounds, level);
        const QuadRange quads = QuadsAround(receiver, level, penumbra.radius, kRingCells);
        UNITY_LOOP
        for (int i = 0; i < CountOf(quads); ++i)
        {
            const int2 quad = QuadAt(quads, i);
            const float4 areas = AreasInRing(quad, level, penumbra.radius, kRingCells, receiver);
            if (!AnyArea(areas)) continue;
            if (level == 0)
                sums = FilterTexels(sums, DepthsInWindow(window, quad, areas), quad, areas, penumbra, receiver);
            else
                sums = FilterCells(sums, CellsInWindow(window, offset, quad, areas), quad, level, areas, penumbra, receiver);
        }
        if (level > 0) offset += window.size.x * window.size.y;
    }
    return LitShare(sums.x, sums.y);
}

float WindowVisibility(QuadReceiver receiver, ConeScales scales, float radius, WindowBounds bounds)
{
    const RingSearch search = SearchWindow(receiver, scales, radius, bounds);
    const RingPenumbra penumbra = PenumbraOf(search, radius, scales);
    if (!penumbra.blocked) return 1.0;
    float visibility = 1.0;
    if (penumbra.readsBlock) visibility = FilterWindowBlock(penumbra, receiver, WindowOf(bounds, 0));
    if (penumbra.readsDisc && visibility > 0.0) visibility = min(visibility, FilterWindowRings(penumbra, receiver, bounds));
    return SanitizeVisibility(visibility);
}

#endif
