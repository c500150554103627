// Penumbra: the visibility of receivers from the windows around their cluster alone.
//
// Computes:   sums over the larger cells around one receiver of each part of 4 x 4 pixels; the visibility of each receiver.
// Source:     Penumbra's own; the filter is that of Filters/PcssAngular.hlsl over every cell of Filters/DepthRings.hlsl in place
//             of samples.
// Inputs:     TileWindows.hlsl, TileParts.hlsl.
// Cost:       no fetches. In search of blockers some 36 texels for each receiver and 2 cells for each level, in the filter 16
//             texels or 28 to 95 cells.
// Guarantees: [0, 1]; no noise: the same map gives the same picture.
// Use it:     in kernels of WINDOW_THREADS threads, all of which call SumRingsOfPart, after LoadWindows.
#ifndef PENUMBRA_TILE_WINDOW_FILTER_HLSL
#define PENUMBRA_TILE_WINDOW_FILTER_HLSL

#include "TileWindows.hlsl"

// Cells each way that hold a ring of the search.
#define SEARCH_CELLS 9
// Texels each way that kGroundReach can reach.
#define GROUND_TEXELS 7

// Where penumbrae are wider, texels, the search needs no cells of one texel.
static const float kNearBlockerTexels = 12.0;
// Sums of all threads of a part are whole numbers, so that their order does not matter: steps for 1, of area / r^2 and of
// area / r, and the most that a thread adds.
static const float2 kSumSteps = float2(1048576.0, 32768.0);
static const float kLargestSum = 134217728.0;

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
    RingSums all = sums;
    UNITY_BRANCH
    if (area > 0.0 && IsInWindow(window, cell))
    {
        const CellBlockers blockers = BlockersOfCell(SpreadInWindow(window, cell), away, width, ground, receiver);
        if (blockers.share > 0.0) all = AddBlockers(sums, blockers, distance, width, area, scales);
    }
    return all;
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

// Whether a texel within the first ring of any of the part's receivers makes a penumbra narrower than kNearBlockerTexels.
void FindNearOfPart(QuadReceiver receiver, ConeScales scales, uint part, uint lane)
{
    const DepthWindow texels = levelWindows[0];
    const float reach = asfloat(partSpread[part]) + kSearchRingCells + 0.5;
    const int2 low = max(int2(floor(receiver.centre - reach)), texels.low);
    const int2 high = min(int2(floor(receiver.centre + reach)), texels.low + texels.size - 1);
    int2 texel = low + PixelOfPart(lane);
    UNITY_LOOP
    while (all(texel <= high) && partNear[part] == 0)
    {
        const CellBlockers blockers = BlockersOfTexel(DepthInWindow(texels, texel), AwayFrom(receiver, texel, 1.0), receiver);
        if (blockers.share > 0.0 && blockers.gap * scales.texelsPerDepth < kNearBlockerTexels) partNear[part] = 1;
        const bool endsRow = texel.x + PART_PIXELS > high.x;
        texel.x = endsRow ? low.x + int(lane % PART_PIXELS) : texel.x + PART_PIXELS;
        texel.y += endsRow ? PART_PIXELS : 0;
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
        int level = 1;
        int n = int(thread % PART_LANES);
        UNITY_LOOP
        while (level <= levels)
        {
            const int2 first = int2(floor(receiver.centre / PowerOfTwo(level))) - SEARCH_CELLS / 2;
            sums = AddRingCell(sums, level, first + PlaceInRows(n, SEARCH_CELLS), level == 1 && !near, receiver, ground, scales,
                               radius);
            n += PART_LANES;
            if (n >= SEARCH_CELLS * SEARCH_CELLS)
            {
                ++level;
                n = int(thread % PART_LANES);
            }
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

// Bits of the depth of a texel in its window, or the packed spread of a cell.
uint CellInWindow(DepthWindow window, int level, int2 cell)
{
    const int2 at = cell - window.low;
    const int place = window.offset + at.y * window.size.x + at.x;
    uint found;
    UNITY_BRANCH
    if (level > 0) found = windowSpreads[min(place, WINDOW_CELLS - 1)];
    else found = asuint(sharedDepths[place]);
    return found;
}

RingState AddWindowCell(RingState state, RingStage stage, CellWalk walk, int level, QuadReceiver receiver, ConeScales scales)
{
    const float2 away = AwayFrom(receiver, walk.cell, PowerOfTwo(level));
    const float area = AreaOfCell(length(away), level, stage);
    RingState next = state;
    UNITY_BRANCH
    if (area > 0.0)
        next = AddCell(state, stage, CellInWindow(walk.window, level, walk.cell), away, level, area, receiver, scales);
    return next;
}

// As FilterBlock of PcssAngular.hlsl.
float FilterWindowBlock(QuadReceiver receiver, RingPenumbra penumbra)
{
    const DepthWindow texels = levelWindows[0];
    float2 sums = float2(0.0, 0.0);
    UNITY_LOOP
    for (int k = 0; k < 16; ++k)
    {
        const int2 texel = CellOfQuad(QuadOfBlock(receiver, k >> 2), k & 3);
        const bool inTile = all(float2(texel) >= receiver.bounds.minimum) && all(float2(texel) < receiver.bounds.maximum);
        const float depth = DepthInWindow(texels, min(max(texel, texels.low), texels.low + texels.size - 1));
        const float2 away = AwayFrom(receiver, texel, 1.0);
        const float distance = length(away);
        const CellBlockers blockers = BlockersOfTexel(depth, away, receiver);
        const float weight = inTile && blockers.gap < penumbra.blockGap ? ShareInBlock(distance, penumbra) : 0.0;
        sums = FilterCell(sums, blockers, distance, 1.0, weight, ConeOfBlock(penumbra));
    }
    return LitShare(sums.x, sums.y);
}

// The search of the levels from the first to the last, and the filter over the disc that it finds, in one walk over cells:
// two loops take FXC twice as long.
RingState SumWindows(RingState before, RingStage search, bool nearPart, uint part, float filterCells, QuadReceiver receiver,
                     ConeScales scales)
{
    RingState state = before;
    RingStage stage = search;
    int level = search.levels.x - 1;
    CellWalk walk = EndedWalk();
    UNITY_LOOP
    while (level <= stage.levels.y)
    {
        UNITY_BRANCH
        if (IsAtCell(walk))
        {
            state = AddWindowCell(state, stage, walk, level, receiver, scales);
            ++walk.cell.x;
        }
        else
        {
            UNITY_BRANCH
            if (IsLastRow(walk))
            {
                ++level;
                UNITY_BRANCH
                if (level > stage.levels.y && stage.index != kDiscStage)
                {
                    if (nearPart) state.search.sums = AddPart(state.search.sums, part);
                    stage = StageOf(kDiscStage, search.radius, state, scales);
                    stage.ringCells = filterCells;
                    level = DiscLevel(stage.radius, filterCells);
                    stage.levels = int2(level, stage.penumbra.readsDisc ? level : -1);
                }
                else if (stage.index != kDiscStage) stage.index = level > 0 ? kCellStage : kTexelStage;
                walk = WalkDisc(receiver, min(level, WINDOW_LEVELS - 1), stage.radius, stage.ringCells);
            }
            walk = EnterNextRow(walk);
        }
    }
    return EndStage(state, kDiscStage);
}

// radius: of the search, texels.
float WindowVisibility(QuadReceiver receiver, ConeScales scales, float radius, FlagshipParameters parameters, uint part)
{
    const bool nearPart = IsNearPart(receiver, scales, part);
    const bool searchesTexels = !nearPart || partNear[part] != 0;
    RingState state = BeginRings(scales);
    if (!searchesTexels) state.search.ground = GroundOfPart(part, scales);
    RingStage search = StageOf(kCellStage, radius, state, scales);
    if (searchesTexels) search.levels.x = 0;
    if (nearPart) search.levels.y = 0;
    state = SumWindows(state, search, nearPart, part, FilterCells(parameters), receiver, scales);
    const RingPenumbra penumbra = PenumbraOf(state.search, radius, scales);
    UNITY_BRANCH
    if (penumbra.readsBlock && state.visibility > 0.0)
        state.visibility = min(state.visibility, FilterWindowBlock(receiver, penumbra));
    return SanitizeVisibility(state.visibility);
}

#endif
