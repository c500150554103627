// Penumbra: a separable Gaussian over one cascade's tile.
//
// Computes:   the taps and weights of one direction.
// Source:     the normal distribution, cut off at 2.5 standard deviations, which keep 98.8 % of it.
// Inputs:     deviation: standard deviation in texels, 0 to kLargestMapDeviation.
// Cost:       1 + 2 ceil(2.5 deviation) fetches for each direction.
// Guarantees: taps stay inside of the tile: texels of its border count for those beyond it. Deviation 0 is one tap.
// Use it:     for maps that may be filtered, moments or exponentials. Not: for raw depths.
#ifndef PENUMBRA_MAP_BLUR_HLSL
#define PENUMBRA_MAP_BLUR_HLSL

static const float kLargestMapDeviation = 4.0;

// The number of taps on each side of the middle one.
int MapBlurReach(float deviation)
{
    return int(ceil(2.5 * deviation));
}

// The weight of the tap `offset` texels from the middle: 1 in the middle, and not normalised.
float MapBlurWeight(int offset, float deviation)
{
    const float ratio = float(offset) / max(deviation, 1e-3);
    return exp2(-0.72134752 * ratio * ratio); // log2(e) / 2
}

int2 MapBlurTexel(int2 texel, int2 offset, float4 tile)
{
    const int2 low = int2(tile.xy);
    const int2 high = low + int2(tile.zw) - 1;
    return min(max(texel + offset, low), high);
}

#endif
