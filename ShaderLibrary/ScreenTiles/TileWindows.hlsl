// Penumbra: the shadow map around a tile's receivers in groupshared memory.
//
// Computes:   windows of texels and of larger cells around a cluster of receivers.
// Source:     Penumbra's own; the cells are those of Filters/Cells/CellRings.hlsl.
// Inputs:     the shadow map; spreads and coarseSpreads, of the kernels FirstLevels and NextLevel, four cells in each
//             texel; TileClusters.hlsl.
// Cost:       a gather for each 2 x 2 texels of the first window, a fetch for each 2 x 2 cells of the others, shared by
//             the cluster. 16 KiB of groupshared memory, with what TileParts.hlsl has.
// Guarantees: reads no texel outside of the receivers' tile.
// Use it:     in kernels of WINDOW_THREADS threads, all of which call the functions that load and join; neighbouring
//             threads for the pixels of one part.
#ifndef PENUMBRA_TILE_WINDOWS_HLSL
#define PENUMBRA_TILE_WINDOWS_HLSL

#include "TileParts.hlsl"
#include "../Filters/Cells/CellSums.hlsl"

#define WINDOW_THREADS 256
// Receivers that are left after so many clusters are filtered alone: a group waits about as long for each further
// cluster as for that.
#if !defined(WINDOW_CLUSTERS)
#define WINDOW_CLUSTERS 2
#endif
// The first window has so many texels each way, and all others together have so many cells. The n-th level has at most
// ceil((2 kWindowReach + 1) / 2^n) + 2 kRingCells + 3 cells each way.
#if !defined(WINDOW_TEXELS)
#define WINDOW_TEXELS 38
#endif
#if !defined(WINDOW_CELLS)
#define WINDOW_CELLS 2251
#endif
// There is a level of texels, and kMostRingLevels of cells beyond it.
#define WINDOW_LEVELS 9

// A receiver may lie this far from the cluster's first receiver, texels along each axis.
static const float kWindowReach = 0.5 * (float(WINDOW_TEXELS) - 3.0) - kRingCells - 1.0;
static const float kFewestFilterCells = 3.0;

struct DepthWindow
{
    int2 low;  // first cell
    int2 size; // cells
    int offset; // offset of the window's first cell among all cells
};

groupshared uint windowSpreads[WINDOW_CELLS];
groupshared DepthWindow levelWindows[WINDOW_LEVELS];
// Each cluster has one of these.
groupshared uint windowFirst[WINDOW_CLUSTERS];
groupshared float2 windowCentre[WINDOW_CLUSTERS];
groupshared uint windowCascade[WINDOW_CLUSTERS];
groupshared TileBounds windowTile[WINDOW_CLUSTERS];
groupshared int windowLeft[WINDOW_CLUSTERS];
groupshared int windowTop[WINDOW_CLUSTERS];
groupshared int windowRight[WINDOW_CLUSTERS];
groupshared int windowBottom[WINDOW_CLUSTERS];
groupshared uint windowRadius[WINDOW_CLUSTERS];

// The distance from the receiver to the edge of the filter's disc, cells; the windows have room for kRingCells.
float FilterCells(int filterCells)
{
    return min(max(float(filterCells), kFewestFilterCells), kRingCells);
}

// The receivers' bounds, in whole texels, and how far around them the windows reach.
struct WindowBounds
{
    int2 low;
    int2 high;
    float radius; // texels
    int levels;   // number of levels beyond the texels
    float ringCells; // ring cells of filter or search, whichever has more
    TileBounds tile;
};

DepthWindow WindowOf(WindowBounds bounds, int level)
{
    const float cell = PowerOfTwo(level);
    const float reach = min(bounds.ringCells * cell, bounds.radius) + cell;
    const int2 low = int2(floor((float2(bounds.low) - reach) / cell));
    const int2 high = int2(floor((float2(bounds.high) + 1.0 + reach) / cell));
    DepthWindow window;
    window.low = max(low, int2(ceil(bounds.tile.minimum / cell)));
    window.size = max(min(high, int2(bounds.tile.maximum / cell) - 1) - window.low + 1, 0);
    window.offset = 0;
    return window;
}

// Threads call it before the group's first barrier.
void ResetWindows(uint thread)
{
    if (thread >= WINDOW_CLUSTERS) return;
    windowFirst[thread] = WINDOW_THREADS;
    windowLeft[thread] = 0x7fffffff;
    windowTop[thread] = 0x7fffffff;
    windowRight[thread] = -2147483647;
    windowBottom[thread] = -2147483647;
    windowRadius[thread] = 0;
}

// Clusters begin with threads in the tile's middle, because the tile's edges see what else lies there.
uint WindowOrder(uint thread)
{
    return (thread + WINDOW_THREADS / 2) % WINDOW_THREADS;
}

// Whether the receiver belongs to the next cluster, and so is near the first of those that wait. radius is that of its
// search, texels.
bool JoinWindow(bool waits, QuadReceiver receiver, float radius, int cascade, uint thread, uint cluster)
{
    const uint part = thread / PART_LANES;
    const uint lane = thread % PART_LANES;
    if (waits) InterlockedMin(windowFirst[cluster], WindowOrder(thread));
    GroupMemoryBarrierWithGroupSync();
    if (WindowOrder(thread) == windowFirst[cluster])
    {
        windowCentre[cluster] = receiver.centre;
        windowCascade[cluster] = uint(cascade);
        windowTile[cluster] = receiver.bounds;
    }
    ResetPart(part, lane);
    GroupMemoryBarrierWithGroupSync();
    const float2 away = abs(receiver.centre - windowCentre[cluster]);
    const bool joins = waits && uint(cascade) == windowCascade[cluster] && max(away.x, away.y) <= kWindowReach;
    if (joins)
    {
        const int2 texel = int2(floor(receiver.centre));
        InterlockedMin(windowLeft[cluster], texel.x);
        InterlockedMin(windowTop[cluster], texel.y);
        InterlockedMax(windowRight[cluster], texel.x);
        InterlockedMax(windowBottom[cluster], texel.y);
        // Floats of one sign have the order of their bits.
        InterlockedMax(windowRadius[cluster], asuint(radius));
        OfferLane(part, lane);
    }
    GroupMemoryBarrierWithGroupSync();
    if (joins && IsLaneOfPart(part, lane)) PutPlane(receiver, radius, part);
    return joins;
}

WindowBounds BoundWindow(uint cluster, float filterCells)
{
    WindowBounds bounds;
    bounds.low = int2(windowLeft[cluster], windowTop[cluster]);
    bounds.high = int2(windowRight[cluster], windowBottom[cluster]);
    bounds.radius = asfloat(windowRadius[cluster]);
    bounds.levels = max(RingLevels(bounds.radius, kSearchRingCells, kMostRingLevels),
                        DiscLevel(bounds.radius, filterCells));
    bounds.ringCells = max(filterCells, kSearchRingCells);
    bounds.tile = windowTile[cluster];
    return bounds;
}

// Threads of a group that nobody joined read nothing.
void LoadWindows(TEXTURE2D_PARAM(shadowMap, sampler_point), Texture2D<uint4> spreads,
                 Texture2D<uint4> coarseSpreads, float2 texelSize, WindowBounds bounds, uint thread)
{
    const bool any = bounds.high.x >= bounds.low.x;
    const DepthWindow texels = WindowOf(bounds, 0);
    const int2 begin = texels.low - (texels.low & 1);
    const int2 quads = any ? (texels.low + texels.size - begin + 1) >> 1 : int2(0, 0);
    if (thread == 0) levelWindows[0] = texels;
    int i;
    PENUMBRA_LOOP
    for (i = int(thread); i < quads.x * quads.y; i += WINDOW_THREADS)
    {
        const int2 first = begin + 2 * PlaceInRows(i, quads.x);
        const float2 uv = float2(first + 1) * texelSize;
        const float4 depths = SanitizeMapDepth(GATHER_RED_TEXTURE2D(shadowMap, sampler_point, uv));
        UNITY_UNROLL
        for (int k = 0; k < 4; ++k)
        {
            const int2 at = first + GatheredTexel(k) - texels.low;
            if (all(at >= 0) && all(at < texels.size)) sharedDepths[at.y * texels.size.x + at.x] = depths[k];
        }
    }
    int offset = 0;
    PENUMBRA_LOOP
    for (int level = 1; level <= bounds.levels; ++level)
    {
        DepthWindow window = WindowOf(bounds, level);
        window.offset = offset;
        if (thread == 0) levelWindows[level] = window;
        const int2 firstBlock = window.low >> 1;
        const int2 blocks = any ? ((window.low + window.size + 1) >> 1) - firstBlock : int2(0, 0);
        PENUMBRA_LOOP
        for (i = int(thread); i < blocks.x * blocks.y; i += WINDOW_THREADS)
        {
            const int2 block = firstBlock + PlaceInRows(i, blocks.x);
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

// The depth of a texel in the first window.
float DepthInWindow(DepthWindow texels, int2 texel)
{
    const int2 at = texel - texels.low;
    return sharedDepths[at.y * texels.size.x + at.x];
}

// The spread of a cell in the window of a level beyond the texels.
DepthSpread SpreadInWindow(DepthWindow window, int2 cell)
{
    const int2 at = cell - window.low;
    return UnpackSpread(windowSpreads[min(window.offset + at.y * window.size.x + at.x, WINDOW_CELLS - 1)]);
}

bool IsInWindow(DepthWindow window, int2 cell)
{
    return all(cell >= window.low) && all(cell < window.low + window.size);
}

// The first and the last cell along an axis whose centres lie within a distance of a receiver; all lengths are in
// cells.
int2 CellsAlong(float centre, float distance, int low, int size)
{
    return int2(max(int(ceil(centre - distance - 0.5)), low), min(int(floor(centre + distance - 0.5)), low + size - 1));
}

int2 CellsOfRow(float2 centre, float distance, int row, DepthWindow window)
{
    const float across = float(row) + 0.5 - centre.y;
    return CellsAlong(centre.x, sqrt(max(distance * distance - across * across, 0.0)), window.low.x, window.size.x);
}

#endif
