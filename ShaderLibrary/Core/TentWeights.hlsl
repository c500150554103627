// Penumbra: a tent-shaped kernel over texels, as bilinear fetches.
//
// Computes:   along one axis, for a tent N texels wide (N = 3, 5, 7) centred anywhere, the (N + 1) / 2 bilinear
//             fetches that together weight every texel by the area of the tent above it.
// Source:     derived here. The tent over [0, N], peak at N/2, has the distribution
//
//                   /\            mass(a, b) = 2 (b - a)(b + a) / N^2              left of the peak
//                  /  \                        2 (b - a)((N - a) + (N - b)) / N^2  right of it
//                 / |  \
//                /| | | \         Products of sums: nothing cancels. Texels that straddle the peak are the sum
//             |_/_|_|_|__\_|      of their two sides.
//               0 1 2 3           (N = 3 touches four texels: two fetches)
//
//             Two neighbouring texels of weights a, b are one bilinear fetch of weight a + b, placed b / (a + b) of
//             the way between their centres (Sigg and Hadwiger, "Fast Third-Order Texture Filtering", GPU Gems 2,
//             2005).
// Inputs:     centre: texel coordinate of the kernel's centre; the texel i covers [i, i + 1].
// Cost:       no fetches.
// Guarantees: weights are multiples of 2^-23 that sum to exactly 1, so in any order of evaluation, with or without
//             fused operations, equal fetches of 1 give exactly 1 and of 0 exactly 0. Each differs from the exact
//             area by less than 2^-22.
// Use it:     as smooth, cheap PCF. Not: where the penumbra is known to be wider than the tent.
#ifndef PENUMBRA_TENT_WEIGHTS_HLSL
#define PENUMBRA_TENT_WEIGHTS_HLSL

#include "../Platform/Platform.hlsl"

// Area of the tent over [0, width] (total 1) between a and b; parts outside the tent add nothing.
float TentMass(float a, float b, float width)
{
    const float peak = 0.5 * width;
    const float leftA = min(max(a, 0.0), peak);
    const float leftB = min(max(b, 0.0), peak);
    const float rightA = width - min(max(a, peak), width);
    const float rightB = width - min(max(b, peak), width);
    return ((leftB - leftA) * (leftB + leftA) + (rightA - rightB) * (rightA + rightB)) * (2.0 / (width * width));
}

float RoundToWeightGrid(float weight)
{
    return floor(weight * 8388608.0 + 0.5) * (1.0 / 8388608.0);
}

// The fetches of one axis: positions are texel coordinates. Unused entries have weight 0.
struct TentAxis
{
    float4 weight;
    float4 position;
};

// taps: 2, 3 or 4, for tents 3, 5 or 7 texels wide.
TentAxis TentFetches(float centre, int taps)
{
    const float width = 2.0 * float(taps) - 1.0;
    const float start = centre - 0.5 * width;
    const float firstTexel = floor(start);
    const float lead = start - firstTexel; // part of the first texel that lies before the tent
    TentAxis axis;
    axis.weight = float4(0.0, 0.0, 0.0, 0.0);
    axis.position = float4(centre, centre, centre, centre);
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const float left = 2.0 * float(i) - lead;
        const float a = TentMass(left, left + 1.0, width);
        const float b = TentMass(left + 1.0, left + 2.0, width);
        const float sum = a + b;
        axis.weight[i] = i < taps ? RoundToWeightGrid(sum) : 0.0;
        axis.position[i] = firstTexel + 2.0 * float(i) + 0.5 + (sum > 0.0 ? min(b / sum, 1.0) : 0.5);
    }
    // The fetch with the largest weight absorbs the rounding error. Every term is a multiple of 2^-23: this is exact.
    axis.weight[1] = 1.0 - (axis.weight[0] + axis.weight[2] + axis.weight[3]);
    return axis;
}

#endif
