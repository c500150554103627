// Penumbra: means over areas of any size, from mip levels.
//
// Computes:   four taps whose mean weighs the map around a position with a given standard deviation, from the mip level
//             in which they overlap.
// Source:     Williams, "Pyramidal Parametrics", 1983. A texel of level L is a box of 2^L texels, variance 4^L / 12;
//             interpolation is a tent of that width, 4^L / 6; together 4^L / 4 along each axis. Four taps at
//             (+-a, +-a) add a^2. At 2^L = deviation the taps are 0.87 of their own width away from the middle.
// Inputs:     a map with mip levels, each texel the mean of four; positions in texel coordinates.
// Cost:       4 filtered fetches.
// Guarantees: no tile's taps read another's texels: levels are used up to the one in which a tile still begins and ends
//             between texels, and taps stay away from the tile's border by half a texel of theirs. There the mean is
//             that of an area moved inward.
// Use it:     for kernels whose width differs from pixel to pixel, where a soft edge of the kernel is welcome. Not:
//             where its border must be exact: Map/SummedArea.hlsl.
#ifndef PENUMBRA_MAP_LEVELS_HLSL
#define PENUMBRA_MAP_LEVELS_HLSL

#include "../Core/PowersOfTwo.hlsl"
#include "../Core/TileBounds.hlsl"

struct LevelTaps
{
    float level;
    float2 at[4]; // positions in texels of level 0
};

// The coarsest level whose texels do not straddle a tile's border.
float CoarsestLevel(TileBounds bounds)
{
    const uint side = uint(max(bounds.maximum.x - bounds.minimum.x, 1.0));
    return float(firstbithigh(side & (~side + 1u)));
}

// The position nearest to `texels` whose footprint, in this level and the next coarser one, stays inside the tile.
float2 ClampToLevel(float2 texels, float level, TileBounds bounds)
{
    const float margin = kBilinearMarginTexels * PowerOfTwo(int(ceil(level)));
    const float2 middle = 0.5 * (bounds.minimum + bounds.maximum);
    const float2 low = min(bounds.minimum + margin, middle);
    const float2 high = max(bounds.maximum - margin, middle);
    return min(max(texels, low), high);
}

LevelTaps TapsOf(float2 centre, float deviation, TileBounds bounds)
{
    LevelTaps taps;
    taps.level = min(max(log2(max(deviation, 1.0)), 0.0), CoarsestLevel(bounds));
    const float width = exp2(taps.level);
    const float apart = sqrt(max(deviation * deviation - 0.25 * width * width, 0.0));
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const float2 side = float2((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0);
        taps.at[i] = ClampToLevel(centre + apart * side, taps.level, bounds);
    }
    return taps;
}

#endif
