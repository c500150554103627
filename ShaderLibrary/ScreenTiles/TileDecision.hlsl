// Penumbra: which tiles of 8 x 8 pixels of the screen are lit or dark as a whole, decided by 16 threads for each.
//
// Computes:   from the places of a tile's pixels in the shadow map, and from bounds of the map's blocks around them,
//             whether no texel can block any pixel, or all of the light is blocked at each; otherwise a radius that no
//             blocker's penumbra there exceeds.
// Source:     Penumbra's own; conservative bounds of blocks as in Dmitriev and Uralsky, "Soft Shadows Using
//             Hierarchical Min-Max Shadow Maps", GDC 2007.
//
//                 \  light's cone  /       a block (a) that lies below the pixels' plane, or beside their cones, blocks
//              [a] \              /        nothing. Where every block in reach is such a one, the tile is lit. Where
//                   \    [b]     /         every block in reach (b) lies above all pixels, by more than the share of
//                    \  /---\   /          the largest gap at which the filter's cone ends, it is dark
//                     \/_____\_/
//
// Inputs:     TilePoint of each pixel, four for each thread; three maps of bounds (Map/DepthBounds.hlsl), of blocks of
//             4, 16 and 64 texels; ConeScales.
// Cost:       one fetch for each block of the finest level that has at most kBlocksAcross blocks each way, three times;
//             six barriers with those of the caller.
// Guarantees: of a lit tile, no texel lies in the cone of rays from any pixel to the light's disc, of which blockers
//             leave no wider penumbra than the softness cap, and above the pixel's plane. The plane of a pixel is that
//             of its quad of pixels; where quads differ, the bounds allow for it.
// Use it:     in kernels with 64 threads for four tiles, all of which call every function here. Not: for spot lights.
#ifndef PENUMBRA_TILE_DECISION_HLSL
#define PENUMBRA_TILE_DECISION_HLSL

#include "../Core/FastLoop.hlsl"
#include "../Core/ReceiverPlane.hlsl"
#include "../Filters/Pcss/PcssBounded.hlsl"
#include "../Map/DepthBounds.hlsl"

#define DECISION_TILES 4
#define DECISION_THREADS 16
#define DECISION_TURNS 3

static const int kDecisionTileBits = 3;
static const int kDecisionTilePixels = 1 << kDecisionTileBits;
static const float kBlocksAcross = 12.0;

// The pixels' flags: a bit for each cascade that covers one of them, and these.
static const uint kCascadeFlags = 15;
static const uint kOutsideFlag = 16; // a pixel that no map covers
static const uint kUnknownFlag = 32; // a pixel whose cascade is chosen by noise

groupshared uint tileFlags[DECISION_TILES];
groupshared uint tileBox[4 * DECISION_TILES];      // smallest x and y, largest x and y, texels
groupshared uint tileDepths[2 * DECISION_TILES];   // largest and smallest gap of pixels before the far end
groupshared uint tileSteepness[DECISION_TILES];    // smallest steepness of a quad, and its thread in the last bits
groupshared uint tileRest[2 * DECISION_TILES];     // largest and smallest gap of pixels before the tile's plane
groupshared uint tileTilt[DECISION_TILES];         // largest tilt of a quad against that plane
groupshared uint tileGap[DECISION_TURNS * DECISION_TILES];
groupshared uint tileSmallestGap[DECISION_TURNS * DECISION_TILES];
groupshared float2 quadGradient[DECISION_THREADS * DECISION_TILES];

static const uint kLargestFloat = 0x7f7fffffu;

// Integers in the order of floats.
uint OrderOfFloat(float value)
{
    const uint bits = asuint(value);
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

float FloatOfOrder(uint order)
{
    return asfloat((order & 0x80000000u) != 0 ? order & 0x7fffffffu : ~order);
}

// A pixel's place in the shadow map.
struct TilePoint
{
    float3 place; // texels of the atlas, stored depth
    bool covered; // whether a map covers it; one that is not is lit
};

// Four pixels of a thread, row by row, and their flags.
struct TileQuad
{
    TilePoint points[4];
    uint flags;
};

// The bounds of all of a tile's pixels.
struct TileBox
{
    uint flags;
    float2 low;        // texels
    float2 high;
    float2 gradient;   // of the tile's plane, stored depth per texel
    float2 middle;     // the plane's rests are measured from here
    float nearestGap;  // of the pixels, before the far end
    float farthestGap;
    float nearestRest; // of the pixels, less the plane's rise from the middle
    float farthestRest;
    float tilt;        // stored depth per texel
};

struct TileDecision
{
    float visibility; // kUndecided, or 0 or 1
    float radius;     // texels
};

uint TileOfThread(uint thread)
{
    return thread / DECISION_THREADS;
}

uint LaneOfThread(uint thread)
{
    return thread % DECISION_THREADS;
}

// Needs a barrier after it.
void ResetDecision(uint thread)
{
    const uint tile = TileOfThread(thread);
    if (LaneOfThread(thread) != 0) return;
    tileFlags[tile] = 0;
    tileBox[4 * tile] = kLargestFloat;
    tileBox[4 * tile + 1] = kLargestFloat;
    tileBox[4 * tile + 2] = 0;
    tileBox[4 * tile + 3] = 0;
    tileDepths[2 * tile] = 0;
    tileDepths[2 * tile + 1] = kLargestFloat;
    tileSteepness[tile] = 0xffffffffu;
    tileRest[2 * tile] = 0;
    tileRest[2 * tile + 1] = 0xffffffffu;
    tileTilt[tile] = 0;
    UNITY_UNROLL
    for (uint turn = 0; turn < DECISION_TURNS; ++turn)
    {
        tileGap[DECISION_TURNS * tile + turn] = 0;
        tileSmallestGap[DECISION_TURNS * tile + turn] = kLargestFloat;
    }
}

bool IsWhole(TileQuad quad)
{
    return (quad.flags & (kOutsideFlag | kUnknownFlag)) == 0;
}

// Begins with a barrier, and has two.
TileBox BoxOfTile(TileQuad quad, uint thread)
{
    const uint tile = TileOfThread(thread);
    const bool any = (quad.flags & kCascadeFlags) != 0;
    const bool whole = IsWhole(quad);
    const float3 across = quad.points[1].place - quad.points[0].place;
    const float3 down = quad.points[2].place - quad.points[0].place;
    const float3 bend = quad.points[3].place - quad.points[2].place - across;
    const float3 right = across + 0.5 * bend;
    const float3 below = down + 0.5 * bend;
    const float2 gradient = whole ? ReceiverPlaneFromDerivatives(right, below) : float2(0.0, 0.0);
    quadGradient[thread] = gradient;
    float2 low = float2(1e30, 1e30);
    float2 high = float2(0.0, 0.0);
    float2 gaps = float2(0.0, 1e30); // x: largest, y: smallest
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        if (!quad.points[i].covered) continue;
        const float gap = DepthGap(quad.points[i].place.z, kFarthestDepth);
        low = min(low, quad.points[i].place.xy);
        high = max(high, quad.points[i].place.xy);
        gaps = float2(max(gaps.x, gap), min(gaps.y, gap));
    }
    GroupMemoryBarrierWithGroupSync();
    InterlockedOr(tileFlags[tile], quad.flags);
    if (any)
    {
        InterlockedMin(tileBox[4 * tile], asuint(max(low.x, 0.0)));
        InterlockedMin(tileBox[4 * tile + 1], asuint(max(low.y, 0.0)));
        InterlockedMax(tileBox[4 * tile + 2], asuint(max(high.x, 0.0)));
        InterlockedMax(tileBox[4 * tile + 3], asuint(max(high.y, 0.0)));
        InterlockedMax(tileDepths[2 * tile], asuint(gaps.x));
        InterlockedMin(tileDepths[2 * tile + 1], asuint(gaps.y));
    }
    const uint steepness = asuint(abs(gradient.x) + abs(gradient.y));
    if (whole) InterlockedMin(tileSteepness[tile], (steepness & 0xfffffff0u) | LaneOfThread(thread));
    GroupMemoryBarrierWithGroupSync();
    TileBox box;
    box.flags = tileFlags[tile];
    box.low = float2(asfloat(tileBox[4 * tile]), asfloat(tileBox[4 * tile + 1]));
    box.high = float2(asfloat(tileBox[4 * tile + 2]), asfloat(tileBox[4 * tile + 3]));
    box.nearestGap = asfloat(tileDepths[2 * tile]);
    box.farthestGap = asfloat(tileDepths[2 * tile + 1]);
    box.middle = 0.5 * (box.low + box.high);
    const uint chosen = tileSteepness[tile];
    box.gradient = quadGradient[DECISION_THREADS * tile + (chosen == 0xffffffffu ? 0 : chosen & 15u)];
    if (any)
    {
        float2 rests = float2(-1e30, 1e30); // x: largest, y: smallest
        UNITY_UNROLL
        for (int j = 0; j < 4; ++j)
        {
            const float rise = dot(box.gradient, quad.points[j].place.xy - box.middle);
            const float rest = DepthGap(quad.points[j].place.z - rise, kFarthestDepth);
            if (quad.points[j].covered) rests = float2(max(rests.x, rest), min(rests.y, rest));
        }
        InterlockedMax(tileRest[2 * tile], OrderOfFloat(rests.x));
        InterlockedMin(tileRest[2 * tile + 1], OrderOfFloat(rests.y));
        // Where a quad is bent, the planes of its pixels differ.
        const float2 tilt = abs(gradient - box.gradient);
        const float span = abs(right.x) + abs(right.y) + abs(below.x) + abs(below.y);
        const float area = max(abs(right.x * below.y - right.y * below.x), 1e-20);
        const float bent = abs(bend.z - dot(box.gradient, bend.xy)) * span / area;
        if (whole) InterlockedMax(tileTilt[tile], asuint(tilt.x + tilt.y + bent));
    }
    GroupMemoryBarrierWithGroupSync();
    box.nearestRest = FloatOfOrder(tileRest[2 * tile]);
    box.farthestRest = FloatOfOrder(tileRest[2 * tile + 1]);
    box.tilt = asfloat(tileTilt[tile]);
    return box;
}

// The sum of what the blocks in reach may do to the tile.
struct BlocksFound
{
    float gap;         // largest gap of a block that may block a pixel; 0 if there is none
    float smallestGap; // smallest gap of a block, 0 unless all lie above the pixels
};

BlocksFound AddBlock(BlocksFound found, DepthPlanes planes, float2 middle, float blockTexels, float reach, TileBox box,
                     ConeScales scales)
{
    // Texels lie at their centres.
    const float halfSpan = HalfSpan(blockTexels);
    const float2 beside = max(max(box.low - middle, middle - box.high) - halfSpan, 0.0);
    const float distance = length(beside);
    if (distance > reach) return found;
    const float nearest = DepthGap(planes.nearest, kFarthestDepth);
    const float farthest = DepthGap(planes.farthest, kFarthestDepth);
    const float own = Parting(planes.gradient, float2(0.0, 0.0), blockTexels);
    const float2 away = middle - box.middle;
    const float rise = DepthGap(dot(box.gradient, away), 0.0);
    const float farEnd = distance + 1.5 * blockTexels;
    const float error = box.tilt * farEnd + kPlanesRounding * (1.0 + dot(abs(box.gradient), abs(away) + farEnd));
    const float parting = Parting(planes.gradient, box.gradient, blockTexels) + error;
    const float largest = nearest + own - box.farthestGap;
    const float cone = max(distance - kSmallestSlackTexels, 0.0) * scales.depthPerTexel;
    const bool mayBlock = nearest - rise + parting > box.farthestRest && largest > cone;
    const bool isAbove = farthest - rise - parting > box.nearestRest;
    BlocksFound next;
    next.gap = mayBlock ? max(found.gap, largest) : found.gap;
    next.smallestGap = min(found.smallestGap, isAbove ? max(farthest - own - box.nearestGap, 0.0) : 0.0);
    return next;
}

// The width of the smallest blocks of which there are at most kBlocksAcross across so many texels, or that of the
// widest: 4, 16 or 64.
float BlocksFor(float texels)
{
    const float narrowest = texels / (kBlocksAcross - 1.0);
    return narrowest <= 4.0 ? 4.0 : narrowest <= 16.0 ? 16.0 : 64.0;
}

uint2 LoadBounds(Texture2D<uint> slopes4, Texture2D<uint> depths4, Texture2D<uint> slopes16, Texture2D<uint> depths16,
                 Texture2D<uint> slopes64, Texture2D<uint> depths64, int2 block, float blockTexels)
{
    uint2 packed;
    UNITY_BRANCH
    if (blockTexels == 4.0) packed = uint2(LOAD_TEXTURE2D(slopes4, block).x, LOAD_TEXTURE2D(depths4, block).x);
    else if (blockTexels == 16.0)
        packed = uint2(LOAD_TEXTURE2D(slopes16, block).x, LOAD_TEXTURE2D(depths16, block).x);
    else packed = uint2(LOAD_TEXTURE2D(slopes64, block).x, LOAD_TEXTURE2D(depths64, block).x);
    return packed;
}

// Whether all pixels that a map covers are in the same cascade.
bool IsOneCascade(TileBox box)
{
    const uint cascades = box.flags & kCascadeFlags;
    return (cascades & (cascades - 1u)) == 0 && (box.flags & kUnknownFlag) == 0;
}

// The bounds are of the levels that BlocksFor() names. It has a barrier for each turn. cap is the radius of the widest
// penumbra, texels.
TileDecision DecideTile(Texture2D<uint> slopes4, Texture2D<uint> depths4, Texture2D<uint> slopes16,
                        Texture2D<uint> depths16, Texture2D<uint> slopes64, Texture2D<uint> depths64, TileBox box,
                        TileBounds map, ConeScales scales, float cap, uint thread)
{
    const uint tile = TileOfThread(thread);
    const uint cascades = box.flags & kCascadeFlags;
    TileDecision decision;
    decision.visibility = (box.flags & (kCascadeFlags | kUnknownFlag)) == 0 ? 1.0 : kUndecided;
    decision.radius = min(min((1.0 - box.farthestGap) * scales.texelsPerDepth, cap), scales.largestRadius);
    const bool unsettled = cascades != 0 && IsOneCascade(box);
    UNITY_LOOP
    for (uint turn = 0; turn < DECISION_TURNS; ++turn)
    {
        const uint place = DECISION_TURNS * tile + turn;
        if (unsettled && decision.visibility < 0.0)
        {
            const float reach = max(decision.radius, kWidestBlockTexels) + kSmallestSlackTexels;
            const float2 low = max(box.low - reach, map.minimum);
            const float2 high = max(min(box.high + reach, map.maximum - 1.0), low);
            const float blockTexels = BlocksFor(max(high.x - low.x, high.y - low.y));
            const int2 first = int2(low / blockTexels);
            const int2 last = int2(high / blockTexels);
            BlocksFound found;
            found.gap = 0.0;
            found.smallestGap = kNoGap;
            const int2 count = last - first + 1;
            const float rowsPerBlock = 1.0 / float(count.x);
            PENUMBRA_LOOP
            for (int i = int(LaneOfThread(thread)); i < count.x * count.y; i += DECISION_THREADS)
            {
                // The half keeps rounding away from whole numbers.
                const int row = int((float(i) + 0.5) * rowsPerBlock);
                const int2 block = first + int2(i - row * count.x, row);
                const uint2 packed =
                    LoadBounds(slopes4, depths4, slopes16, depths16, slopes64, depths64, block, blockTexels);
                found = AddBlock(found, UnpackBounds(packed), (float2(block) + 0.5) * blockTexels, blockTexels, reach,
                                 box, scales);
            }
            if (found.gap > 0.0) InterlockedMax(tileGap[place], asuint(found.gap));
            InterlockedMin(tileSmallestGap[place], asuint(found.smallestGap));
        }
        GroupMemoryBarrierWithGroupSync();
        if (unsettled && decision.visibility < 0.0)
        {
            const float gap = asfloat(tileGap[place]);
            const bool dark = asfloat(tileSmallestGap[place]) > kRoundedShare * kConeHeightShare * gap;
            if (!(gap > 0.0)) decision.visibility = 1.0;
            else if (dark && (box.flags & kOutsideFlag) == 0) decision.visibility = 0.0;
            decision.radius = min(gap * scales.texelsPerDepth, decision.radius);
        }
    }
    return decision;
}

// The largest radius of a word, texels, which bounds nothing.
static const float kUnboundedRadius = 65504.0;

// A tile's word holds its state in the upper half, and a radius in the lower one, rounded up.
uint PackTile(TileDecision decision, bool known)
{
    const uint state = decision.visibility < 0.0 ? 0u : decision.visibility > 0.5 ? 1u : 2u;
    const uint radius = known ? min(f32tof16(decision.radius) + 1, 0x7bffu) : 0x7bffu;
    return (state << 16) | radius;
}

bool IsTileDecided(uint word)
{
    return (word >> 16) != 0;
}

float VisibilityOfTile(uint word)
{
    return (word >> 16) == 1 ? 1.0 : 0.0;
}

float RadiusOfTile(uint word)
{
    return f16tof32(word & 0xffffu);
}

#endif
