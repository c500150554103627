// Penumbra: the shadow map around a tile's receivers in groupshared memory, and what it says of each of them.
//
// Computes:   windows of texels and of larger cells around a cluster of receivers; sums over the larger cells around one
//             receiver of each part of 4 x 4 pixels; the visibility of each receiver, from them alone.
// Source:     Penumbra's own; the filter is that of Filters/PcssAngular.hlsl over every cell of Filters/DepthRings.hlsl in place
//             of samples.
// Inputs:     the shadow map; spreads and coarseSpreads, of the kernels FirstLevels and NextLevel, four cells in each texel;
//             TileClusters.hlsl.
// Cost:       a gather for each 2 x 2 texels of the first window, a fetch for each 2 x 2 cells of the others, shared by the
//             cluster. Arithmetic: in search of blockers some 36 texels for each receiver and 2 cells for each level, in the
//             filter 16 texels or 28 to 95 cells. 16 KiB of groupshared memory.
// Guarantees: [0, 1]; no noise in what the windows give: the same map gives the same picture. Reads no texel outside of the receivers' tile.
// Use it:     in kernels of WINDOW_THREADS threads, all of which call the functions that load, join and sum; neighbouring
//             threads for the pixels of one part.
#ifndef PENUMBRA_TILE_WINDOWS_HLSL
#define PENUMBRA_TILE_WINDOWS_HLSL

#include "FlagshipParameters.hlsl"
#include "TileClusters.hlsl"
#include "../ShaderLibrary/Filters/DepthRingSums.hlsl"

#define WINDOW_THREADS 256
// What is left after these is filtered alone: each further cluster has a group wait about as long as for that.
#if !defined(WINDOW_CLUSTERS)
#define WINDOW_CLUSTERS 2
#endif
// Texels of the first window each way; and cells of all others together: of the n-th level at most
// ceil((2 kWindowReach + 1) / 2^n) + 2 kRingCells + 3 each way.
#if !defined(WINDOW_TEXELS)
#define WINDOW_TEXELS 38
#endif
#if !defined(WINDOW_CELLS)
#define WINDOW_CELLS 2251
#endif
// Cells each way that hold a ring of the search.
#define SEARCH_CELLS 9
// Of texels, and kMostRingLevels beyond them.
#define WINDOW_LEVELS 9
// Texels each way that kGroundReach can reach.
#define GROUND_TEXELS 7

// How far from the cluster's first receiver, texels along each axis, a receiver may lie.
static const float kWindowReach = 0.5 * (float(WINDOW_TEXELS) - 3.0) - kRingCells - 1.0;
static const float kFewestFilterCells = 3.0;
// A receiver so near to the plane of its part's, texels along the light, and so near to it takes its sums.
static const float kPartPlaneTexels = 2.0;
static const float kPartReach = 12.0;
// Where penumbrae are wider, texels, the search needs no cells of one texel.
static const float kNearBlockerTexels = 12.0;
// Sums of all threads of a part are whole numbers, so that their order does not matter: steps for 1, of area / r^2 and of
// area / r, and the most that a thread adds.
static const float2 kSumSteps = float2(1048576.0, 32768.0);
static const float kLargestSum = 134217728.0;

struct DepthWindow
{
    int2 low;  // first cell
    int2 size; // cells
    int offset; // of its first cell among all
};

groupshared uint windowSpreads[WINDOW_CELLS];
groupshared DepthWindow levelWindows[WINDOW_LEVELS];
// Of each cluster.
groupshared uint windowFirst[WINDOW_CLUSTERS];
groupshared float2 windowCentre[WINDOW_CLUSTERS];
groupshared uint windowCascade[WINDOW_CLUSTERS];
groupshared TileBounds windowTile[WINDOW_CLUSTERS];
groupshared int windowLeft[WINDOW_CLUSTERS];
groupshared int windowTop[WINDOW_CLUSTERS];
groupshared int windowRight[WINDOW_CLUSTERS];
groupshared int windowBottom[WINDOW_CLUSTERS];
groupshared uint windowRadius[WINDOW_CLUSTERS];
// Of each part: the receiver whose sums the others take.
groupshared uint partLane[TILE_PARTS];
groupshared float4 partPlane[TILE_PARTS]; // centre, gradient
groupshared float2 partDepth[TILE_PARTS]; // depth, radius of the search
groupshared uint partSums[TILE_PARTS * 4]; // inside, nearby of RingSums, in steps
groupshared uint partGround[TILE_PARTS]; // BlockersOfCell
groupshared uint partSpread[TILE_PARTS]; // farthest receiver along an axis, texels
groupshared uint partNear[TILE_PARTS];   // 1: a texel near the receivers makes a narrow penumbra

// From the receiver to the edge of the filter's disc, cells; the windows have room for kRingCells.
float FilterCells(FlagshipParameters parameters)
{
    return min(max(float(parameters.filterCells), kFewestFilterCells), kRingCells);
}

// Receivers, in whole texels, and how far around them the windows reach.
struct WindowBounds
{
    int2 low;
    int2 high;
    float radius; // texels
    int levels;   // beyond the texels
    float ringCells; // of filter and search, whichever has more
    TileBounds tile;
};

DepthWindow WindowOf(WindowBounds bounds, int level)
{
    const float cell = PowerOfTwo(level);
    const float reach = min(bounds.ringCells * cell, bounds.radius) + cell;
    const int2 low = int2(floor((float2(bounds.low) - reach) / cell));
    const int2 high = int2(floor((float2(bounds.high) + 1.0 + reach) / cell));
    DepthWindow window;
    window.low = max(low, int2(bounds.tile.minimum / cell));
    window.size = max(min(high, int2(bounds.tile.maximum / cell) - 1) - window.low + 1, 0);
    window.offset = 0;
    return window;
}

// Before the group's first barrier.
void ResetWindows(uint thread)
{
    if (thread >= WINDOW_CLUSTERS) return;
    windowFirst[thread] = WINDOW_THREADS;
    windowLeft[thread] = 0x7fffffff;
    windowTop[thread] = 0x7fffffff;
    windowRight[thread] = -0x7fffffff;
    windowBottom[thread] = -0x7fffffff;
    windowRadius[thread] = 0;
}

// From the tile's middle: its edges see what else lies there.
uint WindowOrder(uint thread)
{
    return (thread + WINDOW_THREADS / 2) % WINDOW_THREADS;
}

// From the part's middle.
uint LaneOrder(uint lane)
{
    return (lane + PART_LANES - 5) % PART_LANES;
}

// Whether the receiver is of the next cluster: near the first of those that wait. radius: of its search, texels.
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
    if (lane < 4) partSums[4 * part + lane] = 0;
    if (lane == 0)
    {
        partLane[part] = PART_LANES;
        partGround[part] = 0x7f7fffffu;
        partSpread[part] = 0;
        partNear[part] = 0;
    }
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
        InterlockedMin(partLane[part], LaneOrder(lane));
    }
    GroupMemoryBarrierWithGroupSync();
    if (joins && LaneOrder(lane) == partLane[part])
    {
        partPlane[part] = float4(receiver.centre, receiver.gradient);
        partDepth[part] = float2(receiver.depth, radius);
    }
    return joins;
}

WindowBounds BoundWindow(uint cluster, FlagshipParameters parameters)
{
    WindowBounds bounds;
    bounds.low = int2(windowLeft[cluster], windowTop[cluster]);
    bounds.high = int2(windowRight[cluster], windowBottom[cluster]);
    bounds.radius = asfloat(windowRadius[cluster]);
    const float filterCells = FilterCells(parameters);
    bounds.levels = max(RingLevels(bounds.radius, kSearchRingCells, kMostRingLevels), DiscLevel(bounds.radius, filterCells));
    bounds.ringCells = max(filterCells, kSearchRingCells);
    bounds.tile = windowTile[cluster];
    return bounds;
}

// Threads of a group that nobody joined read nothing.
void LoadWindows(TEXTURE2D_PARAM(shadowMap, sampler_point), TYPED_TEXTURE2D(uint4, spreads),
                 TYPED_TEXTURE2D(uint4, coarseSpreads), float2 texelSize, WindowBounds bounds, uint thread)
{
    const bool any = bounds.high.x >= bounds.low.x;
    const DepthWindow texels = WindowOf(bounds, 0);
    const int2 begin = texels.low - (texels.low & 1);
    const int2 quads = any ? (texels.low + texels.size - begin + 1) / 2 : int2(0, 0);
    if (thread == 0) levelWindows[0] = texels;
    int i;
    UNITY_LOOP
    for (i = int(thread); i < quads.x * quads.y; i += WINDOW_THREADS)
    {
        const int2 first = begin + 2 * int2(i % quads.x, i / quads.x);
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
    UNITY_LOOP
    for (int level = 1; level <= bounds.levels; ++level)
    {
        DepthWindow window = WindowOf(bounds, level);
        window.offset = offset;
        if (thread == 0) levelWindows[level] = window;
        const int2 firstBlock = window.low >> 1;
        const int2 blocks = any ? ((window.low + window.size + 1) >> 1) - firstBlock : int2(0, 0);
        UNITY_LOOP
        for (i = int(thread); i < blocks.x * blocks.y; i += WINDOW_THREADS)
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

// Of a texel in the first window.
float DepthInWindow(DepthWindow texels, int2 texel)
{
    const int2 at = texel - texels.low;
    return sharedDepths[at.y * texels.size.x + at.x];
}

// Of a cell in the window of a level beyond the texels.
DepthSpread SpreadInWindow(DepthWindow window, int2 cell)
{
    const int2 at = cell - window.low;
    return UnpackSpread(windowSpreads[min(window.offset + at.y * window.size.x + at.x, WINDOW_CELLS - 1)]);
}

bool IsInWindow(DepthWindow window, int2 cell)
{
    return all(cell >= window.low) && all(cell < window.low + window.size);
}

// The first and the last cell along an axis whose centres lie within a distance of a receiver; lengths in cells.
int2 CellsAlong(float centre, float distance, int low, int size)
{
    return int2(max(int(ceil(centre - distance - 0.5)), low), min(int(floor(centre + distance - 0.5)), low + size - 1));
}

int2 CellsOfRow(float2 centre, float distance, int row, DepthWindow window)
{
    const float across = float(row) + 0.5 - centre.y;
    return CellsAlong(centre.x, sqrt(max(distance * distance - across * across, 0.0)), window.low.x, window.size.x);
}

// The texels of the first ring.
RingSearch SumTexels(QuadReceiver receiver, ConeScales scales, float radius)
{
    RingSearch search = BeginSearch(scales);
    const DepthWindow texels = levelWindows[0];
    const float farthest = min(kSearchRingCells, radius) + 0.5;
    const int2 rows = CellsAlong(receiver.centre.y, farthest, texels.low.y, texels.size.y);
    UNITY_LOOP
    for (int y = rows.x; y <= rows.y; ++y)
    {
        const int2 row = CellsOfRow(receiver.centre, farthest, y, texels);
        UNITY_LOOP
        for (int x = row.x; x <= row.y; ++x)
        {
            const float2 away = AwayFrom(receiver, int2(x, y), 1.0);
            const float area = ShareInRing(length(away), 0, radius, kSearchRingCells);
            if (area > 0.0)
                search = SearchTexel(search, DepthInWindow(texels, int2(x, y)), away, area, receiver, scales);
        }
    }
    return search;
}

// Of a cell, where the receiver's ring has it. filled: with what the ring encloses.
RingSums AddRingCell(RingSums sums, int level, int2 cell, bool filled, QuadReceiver receiver, float ground, ConeScales scales,
                     float radius)
{
    const float width = PowerOfTwo(level);
    const DepthWindow window = levelWindows[level];
    const float2 away = AwayFrom(receiver, cell, width);
    const float distance = length(away);
    const float share = filled ? ShareInDisc(distance, level, radius, kSearchRingCells)
                               : ShareInRing(distance, level, radius, kSearchRingCells);
    const float area = share * width * width;
    if (!(area > 0.0) || !IsInWindow(window, cell)) return sums;
    const CellBlockers blockers = BlockersOfCell(SpreadInWindow(window, cell), away, width, ground, receiver);
    if (!(blockers.share > 0.0)) return sums;
    return AddBlockers(sums, blockers, distance, width, area, scales);
}

// The rings beyond the first, by one thread.
RingSums SumRings(RingSums sums, QuadReceiver receiver, float ground, ConeScales scales, float radius)
{
    RingSums all = sums;
    const int levels = RingLevels(radius, kSearchRingCells, kMostRingLevels);
    UNITY_LOOP
    for (int level = 1; level <= levels; ++level)
    {
        const float width = PowerOfTwo(level);
        const float2 centre = receiver.centre / width;
        const float farthest = min(kSearchRingCells, radius / width) + 0.5;
        const DepthWindow window = levelWindows[level];
        const int2 rows = CellsAlong(centre.y, farthest, window.low.y, window.size.y);
        UNITY_LOOP
        for (int y = rows.x; y <= rows.y; ++y)
        {
            const int2 row = CellsOfRow(centre, farthest, y, window);
            UNITY_LOOP
            for (int x = row.x; x <= row.y; ++x)
                all = AddRingCell(all, level, int2(x, y), false, receiver, ground, scales, radius);
        }
    }
    return all;
}

// The receiver of the part whose sums the others take; `like` is any receiver of the same tile.
QuadReceiver ReceiverOfPart(uint part, QuadReceiver like)
{
    QuadReceiver receiver = like;
    receiver.centre = partPlane[part].xy;
    receiver.gradient = partPlane[part].zw;
    receiver.depth = partDepth[part].x;
    return receiver;
}

// Whether the receiver is near enough to the part's to take its sums.
bool IsNearPart(QuadReceiver receiver, ConeScales scales, uint part)
{
    const QuadReceiver other = ReceiverOfPart(part, receiver);
    const float2 away = receiver.centre - other.centre;
    const float beside = abs(receiver.depth - PlaneDepth(other, away));
    return beside <= kPartPlaneTexels * UsualGround(scales) && max(abs(away.x), abs(away.y)) <= kPartReach;
}

uint2 StepsOfSum(float2 sum)
{
    return uint2(min(sum * kSumSteps + 0.5, kLargestSum));
}

// The ground below the part's receiver, by all of its threads.
void FindGroundOfPart(QuadReceiver receiver, ConeScales scales, uint part, uint lane)
{
    const DepthWindow texels = levelWindows[0];
    const int2 here = int2(floor(receiver.centre));
    UNITY_LOOP
    for (uint n = lane; n < GROUND_TEXELS * GROUND_TEXELS; n += PART_LANES)
    {
        const int2 texel = here + int2(n % GROUND_TEXELS, n / GROUND_TEXELS) - GROUND_TEXELS / 2;
        const float2 away = AwayFrom(receiver, texel, 1.0);
        if (!IsInWindow(texels, texel) || !(length(away) < kGroundReach)) continue;
        bool found = false;
        const float ground = GroundWithTexel(0.0, found, DepthInWindow(texels, texel), away, receiver, scales);
        if (found) InterlockedMin(partGround[part], asuint(ground));
    }
}

float GroundOfPart(uint part, ConeScales scales)
{
    const float found = asfloat(partGround[part]);
    return found < kDeepestGround * UsualGround(scales) ? found : UsualGround(scales);
}

// Whether a texel within the first ring of any of the part's receivers makes a penumbra narrower than kNearBlockerTexels.
void FindNearOfPart(QuadReceiver receiver, ConeScales scales, uint part, uint lane)
{
    const DepthWindow texels = levelWindows[0];
    const float reach = asfloat(partSpread[part]) + kSearchRingCells + 0.5;
    const int2 low = max(int2(floor(receiver.centre - reach)), texels.low);
    const int2 high = min(int2(floor(receiver.centre + reach)), texels.low + texels.size - 1);
    UNITY_LOOP
    for (int2 texel = low + PixelOfPart(lane); texel.y <= high.y && partNear[part] == 0; texel.y += PART_PIXELS)
    {
        UNITY_LOOP
        for (texel.x = low.x + int(lane % PART_PIXELS); texel.x <= high.x; texel.x += PART_PIXELS)
        {
            const CellBlockers blockers =
                BlockersOfTexel(DepthInWindow(texels, texel), AwayFrom(receiver, texel, 1.0), receiver);
            if (blockers.share > 0.0 && blockers.gap * scales.texelsPerDepth < kNearBlockerTexels) partNear[part] = 1;
        }
    }
}

// The rings beyond the first around the part's receiver, by all of its threads; also the first, where no texel there makes a
// narrow penumbra. own: any receiver of the same cascade.
void SumRingsOfPart(bool joins, QuadReceiver own, ConeScales scales, uint thread)
{
    const uint part = thread / PART_LANES;
    const bool any = partLane[part] < PART_LANES;
    const QuadReceiver receiver = ReceiverOfPart(part, own);
    const float2 apart = abs(own.centre - receiver.centre);
    if (joins && IsNearPart(own, scales, part)) InterlockedMax(partSpread[part], asuint(max(apart.x, apart.y)));
    if (any) FindGroundOfPart(receiver, scales, part, thread % PART_LANES);
    GroupMemoryBarrierWithGroupSync();
    if (any) FindNearOfPart(receiver, scales, part, thread % PART_LANES);
    GroupMemoryBarrierWithGroupSync();
    const bool near = partNear[part] != 0;
    const float ground = GroundOfPart(part, scales);
    RingSums sums = NoBlockers();
    if (any)
    {
        const float radius = partDepth[part].y;
        const int levels = RingLevels(radius, kSearchRingCells, kMostRingLevels);
        UNITY_LOOP
        for (int level = 1; level <= levels; ++level)
        {
            const int2 first = int2(floor(receiver.centre / PowerOfTwo(level))) - SEARCH_CELLS / 2;
            UNITY_LOOP
            for (int n = int(thread % PART_LANES); n < SEARCH_CELLS * SEARCH_CELLS; n += PART_LANES)
                sums = AddRingCell(sums, level, first + int2(n % SEARCH_CELLS, n / SEARCH_CELLS), level == 1 && !near, receiver,
                                   ground, scales, radius);
        }
    }
    if (sums.nearby.x > 0.0)
    {
        const uint2 inside = StepsOfSum(sums.inside);
        const uint2 nearby = StepsOfSum(sums.nearby);
        InterlockedAdd(partSums[4 * part], inside.x);
        InterlockedAdd(partSums[4 * part + 1], inside.y);
        InterlockedAdd(partSums[4 * part + 2], nearby.x);
        InterlockedAdd(partSums[4 * part + 3], nearby.y);
    }
    GroupMemoryBarrierWithGroupSync();
}

RingSums AddPart(RingSums sums, uint part)
{
    const uint first = 4 * part;
    RingSums all = sums;
    all.inside += float2(partSums[first], partSums[first + 1]) / kSumSteps;
    all.nearby += float2(partSums[first + 2], partSums[first + 3]) / kSumSteps;
    return all;
}

// The first of the block's quads, of level 0.
float4 DepthsInWindow(DepthWindow texels, int2 first)
{
    float4 depths;
    UNITY_UNROLL
    for (int k = 0; k < 4; ++k)
    {
        const int2 texel = min(max(first + int2(k & 1, k >> 1), texels.low), texels.low + texels.size - 1);
        depths[k] = DepthInWindow(texels, texel);
    }
    return depths;
}

float FilterWindowBlock(QuadReceiver receiver, RingPenumbra penumbra)
{
    const DepthWindow texels = levelWindows[0];
    float2 sums = float2(0.0, 0.0);
    UNITY_LOOP
    for (int k = 0; k < 4; ++k)
    {
        const int2 first = QuadOfBlock(receiver, k);
        sums = FilterBlockQuad(sums, DepthsInWindow(texels, first), first, penumbra, receiver);
    }
    return LitShare(sums.x, sums.y);
}

// As FilterDisc of PcssAngular.hlsl, over every cell of the disc, of DiscLevel.
float FilterWindowDisc(QuadReceiver receiver, RingPenumbra penumbra, float filterCells)
{
    const int level = DiscLevel(penumbra.radius, filterCells);
    const DepthWindow window = levelWindows[level];
    const float width = PowerOfTwo(level);
    const float2 centre = receiver.centre / width;
    const float farthest = min(filterCells, penumbra.radius / width) + 0.5;
    const int2 rows = CellsAlong(centre.y, farthest, window.low.y, window.size.y);
    float2 sums = float2(0.0, 0.0);
    UNITY_LOOP
    for (int y = rows.x; y <= rows.y; ++y)
    {
        const int2 row = CellsOfRow(centre, farthest, y, window);
        UNITY_LOOP
        for (int x = row.x; x <= row.y; ++x)
        {
            const float2 away = AwayFrom(receiver, int2(x, y), width);
            const float distance = length(away);
            CellBlockers blockers;
            if (level == 0) blockers = BlockersOfTexel(DepthInWindow(window, int2(x, y)), away, receiver);
            else blockers = BlockersOfCell(SpreadInWindow(window, int2(x, y)), away, width, penumbra.ground, receiver);
            const float share = ShareInDisc(distance, level, penumbra.radius, filterCells);
            sums = FilterCell(sums, blockers, distance, width, share, penumbra.cone);
        }
    }
    return LitShare(sums.x, sums.y);
}

// radius: of the search, texels.
float WindowVisibility(QuadReceiver receiver, ConeScales scales, float radius, FlagshipParameters parameters, uint part)
{
    const bool nearPart = IsNearPart(receiver, scales, part);
    RingSearch search = BeginSearch(scales);
    search.ground = GroundOfPart(part, scales);
    if (!nearPart || partNear[part] != 0) search = SumTexels(receiver, scales, radius);
    if (nearPart) search.sums = AddPart(search.sums, part);
    else search.sums = SumRings(search.sums, receiver, search.ground, scales, radius);
    const RingPenumbra penumbra = PenumbraOf(search, radius, scales);
    if (!penumbra.blocked) return 1.0;
    float visibility = 1.0;
    if (penumbra.readsBlock) visibility = FilterWindowBlock(receiver, penumbra);
    if (penumbra.readsDisc && visibility > 0.0) visibility = min(visibility, FilterWindowDisc(receiver, penumbra, FilterCells(parameters)));
    return SanitizeVisibility(visibility);
}

#endif
