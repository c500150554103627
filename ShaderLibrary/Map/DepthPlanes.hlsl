// Penumbra: two parallel planes that hold the depths of a block of the shadow map between them.
//
// Computes:   planes of a block of 4 x 4 texels, and of a block of four blocks.
// Source:     derived here. Like a range of depths (DepthRange.hlsl), but it stays narrow on slopes, where a range is
//             as wide as the slope's rise over the block. The slope of 16 texels is that of the least squares; of four
//             blocks it is the mean of theirs. Any slope would do: the planes are moved to hold every texel's centre.
// Inputs:     stored depths in [0, 1], either direction, sanitised; offsets from the block's centre in texels.
// Cost:       no fetches.
// Guarantees: finite for any depths. Every texel of the block lies between the planes at its own centre, within
//             kPlanesRounding of the sizes involved.
// Use it:     to tell a lit slope from a blocker. Not: with fewer than 32 bits, which would need rounding outward.
#ifndef PENUMBRA_DEPTH_PLANES_HLSL
#define PENUMBRA_DEPTH_PLANES_HLSL

#include "DepthRange.hlsl"

// The rounding of ten levels, each with a few roundings of floats.
static const float kPlanesRounding = 4e-6;

// The gradient in stored depth per texel, and the stored depths of both planes at the block's centre.
struct DepthPlanes
{
    float2 gradient;
    float nearest;
    float farthest;
};

float4 PackPlanes(DepthPlanes planes)
{
    return float4(planes.gradient, planes.nearest, planes.farthest);
}

DepthPlanes UnpackPlanes(float4 packed)
{
    DepthPlanes planes;
    planes.gradient = packed.xy;
    planes.nearest = packed.z;
    planes.farthest = packed.w;
    return planes;
}

// The positions of a gather's texels, from the corner that they share (TexelQuad.hlsl).
static const float4 kGatherX = float4(-0.5, 0.5, 0.5, -0.5);
static const float4 kGatherY = float4(0.5, 0.5, -0.5, -0.5);

float2 QuarterCorner(int quarter)
{
    return float2((quarter & 1) == 0 ? -1.0 : 1.0, quarter < 2 ? -1.0 : 1.0);
}

// depths holds those of the four quarters of 4 x 4 texels.
DepthPlanes PlanesOfBlock(float4 depths[4])
{
    DepthPlanes planes;
    planes.gradient = float2(0.0, 0.0);
    int i;
    UNITY_UNROLL
    for (i = 0; i < 4; ++i)
        planes.gradient += float2(dot(depths[i], QuarterCorner(i).x + kGatherX),
                                  dot(depths[i], QuarterCorner(i).y + kGatherY));
    planes.gradient /= 20.0; // the sum of x^2 over 16 texels
    float2 range = kEmptyRange;
    UNITY_UNROLL
    for (i = 0; i < 4; ++i)
    {
        const float4 rest = depths[i] - planes.gradient.x * (QuarterCorner(i).x + kGatherX) -
                            planes.gradient.y * (QuarterCorner(i).y + kGatherY);
        range = i == 0 ? RangeOfFour(rest) : JoinRanges(range, RangeOfFour(rest));
    }
    planes.nearest = range.x;
    planes.farthest = range.y;
    return planes;
}

// The distance from a block's centre to the outermost centres of its texels, along each axis.
float HalfSpan(float blockTexels)
{
    return 0.5 * (blockTexels - 1.0);
}

// The distance by which two planes that meet at a block's centre part within the block.
float Parting(float2 gradient, float2 otherGradient, float blockTexels)
{
    const float2 tilt = abs(gradient - otherGradient);
    return (tilt.x + tilt.y) * HalfSpan(blockTexels);
}

// parts holds the planes of the four blocks, blockTexels wide, of a block twice as wide, row by row.
DepthPlanes JoinPlanes(DepthPlanes parts[4], float blockTexels)
{
    DepthPlanes whole;
    whole.gradient = 0.25 * ((parts[0].gradient + parts[1].gradient) + (parts[2].gradient + parts[3].gradient));
    float2 range = kEmptyRange;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const float toPart = dot(whole.gradient, QuarterCorner(i) * (0.5 * blockTexels));
        const float parting = Parting(parts[i].gradient, whole.gradient, blockTexels);
        const float2 planes = float2(MoveTowardLight(parts[i].nearest - toPart, parting),
                                     MoveTowardLight(parts[i].farthest - toPart, -parting));
        range = i == 0 ? planes : JoinRanges(range, planes);
    }
    whole.nearest = range.x;
    whole.farthest = range.y;
    return whole;
}

#endif
