// Penumbra: the visibility of receivers from the windows around their cluster alone.
//
// Computes:   sums over the larger cells around one receiver of each part of 4 x 4 pixels; the visibility of each
//             receiver.
// Source:     Penumbra's own; the filter is that of PcssAngular.hlsl over every cell of CellRings.hlsl in place of
//             samples.
// Inputs:     TileWindows.hlsl, TileParts.hlsl.
// Cost:       no fetches. In search of blockers some 36 texels for each receiver and 2 cells for each level, in the
//             filter 16 texels or 28 to 95 cells.
// Guarantees: [0, 1]; no noise: the same map gives the same picture.
// Use it:     in kernels of WINDOW_THREADS threads, all of which call SumRingsOfPart, after LoadWindows.
#ifndef PENUMBRA_TILE_WINDOW_FILTER_HLSL
#define PENUMBRA_TILE_WINDOW_FILTER_HLSL

#include "TileWindows.hlsl"

// A ring of the search is held by so many cells each way.
#define SEARCH_CELLS 9
// kGroundReach can reach so many texels each way.
#define GROUND_TEXELS 7

// Where penumbrae are wider than this, texels, the search needs no cells of one texel.
static const float kNearBlockerTexels = 12.0;
// Sums of all threads of a part are whole numbers, so that their order does not matter. These are the steps for 1, of
// area / r^2 and of area / r, and the most that a thread adds.
static const float2 kSumSteps = float2(1048576.0, 32768.0);
static const float kLargestSum = 134217728.0;

// Searches the texels of the first ring.
RingSearch SumTexels(QuadReceiver receiver, ConeScales scales, float radius)
{
    RingSearch search = BeginSearch(scales);
    const DepthWindow texels = levelWindows[0];
    const float farthest = min(kSearchRingCells, radius) + 0.5;
    const int2 rows = CellsAlong(receiver.centre.y, farthest, texels.low.y, texels.size.y);
    PENUMBRA_LOOP
    for (int y = rows.x; y <= rows.y; ++y)
    {
        const int2 row = CellsOfRow(receiver.centre, farthest, y, texels);
        PENUMBRA_LOOP
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

// Adds a cell where the receiver's ring has it; if filled, also where the ring encloses it.
RingSums AddRingCell(RingSums sums, int level, int2 cell, bool filled, QuadReceiver receiver, float ground,
                     ConeScales scales, float radius)
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

// One thread sums the rings beyond the first.
RingSums SumRings(RingSums sums, QuadReceiver receiver, float ground, ConeScales scales, float radius)
{
    RingSums all = sums;
    const int levels = RingLevels(radius, kSearchRingCells, kMostRingLevels);
    PENUMBRA_LOOP
    for (int level = 1; level <= levels; ++level)
    {
        const float width = PowerOfTwo(level);
        const float2 centre = receiver.centre / width;
        const float farthest = min(kSearchRingCells, radius / width) + 0.5;
        const DepthWindow window = levelWindows[level];
        const int2 rows = CellsAlong(centre.y, farthest, window.low.y, window.size.y);
        PENUMBRA_LOOP
        for (int y = rows.x; y <= rows.y; ++y)
        {
            const int2 row = CellsOfRow(centre, farthest, y, window);
            PENUMBRA_LOOP
            for (int x = row.x; x <= row.y; ++x)
                all = AddRingCell(all, level, int2(x, y), false, receiver, ground, scales, radius);
        }
    }
    return all;
}

uint2 StepsOfSum(float2 sum)
{
    return uint2(min(sum * kSumSteps + 0.5, kLargestSum));
}

// All threads of the part find the ground below its receiver.
void FindGroundOfPart(QuadReceiver receiver, ConeScales scales, uint part, uint lane)
{
    const DepthWindow texels = levelWindows[0];
    const int2 here = int2(floor(receiver.centre));
    PENUMBRA_LOOP
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

// Whether a texel within the first ring of any of the part's receivers makes a penumbra narrower than
// kNearBlockerTexels.
void FindNearOfPart(QuadReceiver receiver, ConeScales scales, uint part, uint lane)
{
    const DepthWindow texels = levelWindows[0];
    const float reach = asfloat(partSpread[part]) + kSearchRingCells + 0.5;
    const int2 low = max(int2(floor(receiver.centre - reach)), texels.low);
    const int2 high = min(int2(floor(receiver.centre + reach)), texels.low + texels.size - 1);
    PENUMBRA_LOOP
    for (int2 texel = low + PixelOfPart(lane); texel.y <= high.y && partNear[part] == 0; texel.y += PART_PIXELS)
    {
        PENUMBRA_LOOP
        for (texel.x = low.x + int(lane % PART_PIXELS); texel.x <= high.x; texel.x += PART_PIXELS)
        {
            const CellBlockers blockers =
                BlockersOfTexel(DepthInWindow(texels, texel), AwayFrom(receiver, texel, 1.0), receiver);
            if (blockers.share > 0.0 && blockers.gap * scales.texelsPerDepth < kNearBlockerTexels) partNear[part] = 1;
        }
    }
}

// All threads of the part sum the rings beyond the first around its receiver; also the first, where no texel there
// makes a narrow penumbra. own is any receiver of the same cascade.
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
        PENUMBRA_LOOP
        for (int level = 1; level <= levels; ++level)
        {
            const int2 first = int2(floor(receiver.centre / PowerOfTwo(level))) - SEARCH_CELLS / 2;
            PENUMBRA_LOOP
            for (int n = int(thread % PART_LANES); n < SEARCH_CELLS * SEARCH_CELLS; n += PART_LANES)
                sums = AddRingCell(sums, level, first + PlaceInRows(n, SEARCH_CELLS), level == 1 && !near, receiver,
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

float FilterWindowBlock(QuadReceiver receiver, RingPenumbra penumbra)
{
    const DepthWindow texels = levelWindows[0];
    const int2 first = QuadOfBlock(receiver, 0);
    float2 sums = float2(0.0, 0.0);
    PENUMBRA_LOOP
    for (int k = 0; k < 16; ++k)
    {
        const int2 texel = first + int2(k & 3, k >> 2);
        const int2 inWindow = min(max(texel, texels.low), texels.low + texels.size - 1);
        sums = FilterBlockTexel(sums, DepthInWindow(texels, inWindow), texel, penumbra, receiver);
    }
    return LitShare(sums.x, sums.y);
}

// The filter of FilterDisc of PcssAngular.hlsl, over every cell of the disc, of DiscLevel.
float FilterWindowDisc(QuadReceiver receiver, RingPenumbra penumbra, float filterCells)
{
    const int level = DiscLevel(penumbra.radius, filterCells);
    const DepthWindow window = levelWindows[level];
    const float width = PowerOfTwo(level);
    const float2 centre = receiver.centre / width;
    const float farthest = min(filterCells, penumbra.radius / width) + 0.5;
    const int2 rows = CellsAlong(centre.y, farthest, window.low.y, window.size.y);
    float2 sums = float2(0.0, 0.0);
    PENUMBRA_LOOP
    for (int y = rows.x; y <= rows.y; ++y)
    {
        const int2 row = CellsOfRow(centre, farthest, y, window);
        PENUMBRA_LOOP
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

// radius is the search's, texels.
float WindowVisibility(QuadReceiver receiver, ConeScales scales, float radius, float filterCells, uint part)
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
    if (penumbra.readsDisc && visibility > 0.0)
        visibility = min(visibility, FilterWindowDisc(receiver, penumbra, filterCells));
    return SanitizeVisibility(visibility);
}

#endif
