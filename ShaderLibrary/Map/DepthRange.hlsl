// Penumbra: the nearest and the farthest depth of blocks of the shadow map.
//
// Computes:   ranges of depth, joined, rounded outward to 16 bits, and how far a circular dilation of them reaches.
// Source:     Dmitriev and Uralsky, "Soft shadows using hierarchical min-max shadow maps", GDC 2007. Dilation by a disc
//             whose radius depends on the cascade: Candycat, "Graphics Study: RDR2, shadows" (2021), there 8, 4, 3 and
//             0 texels of the quarter-resolution map, which are 32, 16, 12 and 0 texels of the shadow map. Its listing
//             starts the maximum at FLT_MIN, which is positive; here a range starts empty.
// Inputs:     stored depths in [0, 1], either direction, sanitised: NaN is farthest.
// Cost:       no fetches.
// Guarantees: a range's nearest depth is never farther than any depth of its block and its farthest never nearer, also
//             after it was stored in a texture of two 16-bit integers: see RoundRangeOutward. Joins of stored ranges
//             are stored exactly.
// Use it:     for maps that tell where nothing, or everything, blocks. Not: with filtering, since a mean of bounds is
//             no bound.
#ifndef PENUMBRA_DEPTH_RANGE_HLSL
#define PENUMBRA_DEPTH_RANGE_HLSL

#include "../Core/DepthConvention.hlsl"
#include "../Core/FloatBits.hlsl"
#include "../Core/PowersOfTwo.hlsl"
#include "../Core/TileBounds.hlsl"

// Texels of the shadow map per texel of the quarter-resolution map, each way.
static const float kRangeBlock = 4.0;
// This value stands for a visibility where bounds of the depths do not tell whether it is 1 or 0.
static const float kUndecided = -1.0;
static const int kLargestDilation = 16;

// The range that any other replaces when the two are joined. x is the depth nearest to the light, y the farthest; both
// are stored depths.
static const float2 kEmptyRange = float2(kFarthestDepth, kNearestDepth);

float NearerDepth(float a, float b)
{
    return DepthGap(a, b) > 0.0 ? a : b;
}

float FartherDepth(float a, float b)
{
    return DepthGap(a, b) > 0.0 ? b : a;
}

float2 JoinRanges(float2 a, float2 b)
{
    return float2(NearerDepth(a.x, b.x), FartherDepth(a.y, b.y));
}

float2 RangeOfFour(float4 depths)
{
    const float nearest = NearerDepth(NearerDepth(depths.x, depths.y), NearerDepth(depths.z, depths.w));
    const float farthest = FartherDepth(FartherDepth(depths.x, depths.y), FartherDepth(depths.z, depths.w));
    return float2(nearest, farthest);
}

// Rounds to a multiple of 1/65535 that is not nearer than `depth` (direction -1) or not farther (1, toward the light).
// The margin of 1/64 step is more than what floats lose: the product loses at most 1/512 of a step, a texture's
// conversion from integers 1/128.
float RoundDepthOutward(float depth, float direction)
{
    const float steps = 65535.0 * depth;
    const float rounded = direction * kTowardLight > 0.0 ? ceil(steps + 0.015625) : floor(steps - 0.015625);
    return min(max(rounded, 0.0), 65535.0) / 65535.0;
}

// Takes a range of depths, not a stored range: stored ones are multiples already, and would grow by a step.
float2 RoundRangeOutward(float2 range)
{
    return float2(RoundDepthOutward(range.x, 1.0), RoundDepthOutward(range.y, -1.0));
}

// Whether the texel `offset` away belongs to a disc of that radius: a disc of radius 8 has 197 texels, discs of 4, 3
// and 0 have 49, 29 and 1. Integers serve here because a square root may be rounded either way.
bool InDilation(int2 offset, int radius)
{
    return offset.x * offset.x + offset.y * offset.y <= radius * radius;
}

// Radius, texels of the shadow map, of a disc around any point of a block that a dilation of `radius` texels of the
// quarter-resolution map covers. Cells that are left out are more than `radius` away, from centre to centre; from
// the nearest points of both cells it is up to a diagonal less.
float DilationReach(int radius)
{
    return kRangeBlock * max(float(radius) - 1.4142136, 0.0);
}

// The block of level `level` that contains a position in texels of the shadow map; for a position beside the tile, the
// tile's nearest block.
int2 BlockAt(float2 texels, int level, TileBounds bounds)
{
    const float2 inside = min(max(texels, bounds.minimum), max(bounds.maximum - 1.0, bounds.minimum));
    return int2(inside) >> (2 + level);
}

// The highest level whose blocks divide the tile.
int HighestWholeLevel(TileBounds bounds)
{
    const uint2 blocks = max(uint2(bounds.maximum - bounds.minimum) / 4u, 1u);
    return int(firstbitlow(blocks.x | blocks.y));
}

// The blocks, at most `across` x `across`, that hold the tile's part of a disc or of a box.
struct DiscBlocks
{
    int level;
    int2 low;
    int2 high;
    bool whole; // false: no level has so few, or the tile does not consist of whole blocks
};

DiscBlocks BlocksOfBox(float2 low, float2 high, int across, TileBounds bounds)
{
    DiscBlocks blocks;
    const float narrowest = max(high.x - low.x, high.y - low.y) / (kRangeBlock * float(across - 1));
    blocks.level = min(CeilLog2(max(narrowest, 1.0)), HighestWholeLevel(bounds));
    blocks.low = BlockAt(low, blocks.level, bounds);
    blocks.high = BlockAt(high, blocks.level, bounds);
    const float2 beyond = fmod(bounds.minimum, kRangeBlock) + fmod(bounds.maximum, kRangeBlock);
    blocks.whole = all(blocks.high - blocks.low < across) && beyond.x + beyond.y == 0.0;
    return blocks;
}

DiscBlocks BlocksOfDisc(float2 centre, float radius, int across, TileBounds bounds)
{
    return BlocksOfBox(centre - radius, centre + radius, across, bounds);
}

// The next block, row by row from `low` on; HoldsBlock is false after the last one.
int2 NextBlock(int2 texel, DiscBlocks blocks)
{
    return texel.x < blocks.high.x ? int2(texel.x + 1, texel.y) : int2(blocks.low.x, texel.y + 1);
}

bool HoldsBlock(int2 texel, DiscBlocks blocks)
{
    return blocks.whole && texel.y <= blocks.high.y;
}

#endif
