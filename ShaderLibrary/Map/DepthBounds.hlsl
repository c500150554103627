// Penumbra: two parallel planes that hold the depths of a block of the shadow map between them, in eight bytes.
//
// Computes:   the packed planes of a block, and planes again from these.
// Source:     Map/DepthPlanes.hlsl. The gradient is stored as two halves; the plane nearer to the light in 20 bits,
//             rounded toward the light; the distance between both in 12, which are a half's, rounded up, without its
//             sign and its last three bits.
// Inputs:     DepthPlanes of a block, of stored depths in [0, 1], either direction.
// Cost:       no fetches.
// Guarantees: every texel of the block lies between the unpacked planes at its own centre, within kPlanesRounding of
//             the sizes involved. Planes that leave the range of the 20 bits become those between which every map lies.
// Use it:     to keep the levels of a map of planes small. Not: to join them, which adds up the rounding.
#ifndef PENUMBRA_DEPTH_BOUNDS_HLSL
#define PENUMBRA_DEPTH_BOUNDS_HLSL

#include "DepthPlanes.hlsl"

// The nearer plane has 2^20 steps, over depths half a map in front of the map to half a map behind it.
static const float kBoundSteps = 524288.0;
static const float kBoundRange = 0.5;
// The planes of a block of which nothing is known: the nearer one 3/2 before the far end, the other two behind that.
static const uint kUnknownBound = 0xfffff800u;

uint2 PackBounds(DepthPlanes planes, float blockTexels)
{
    const uint2 halves = f32tof16(planes.gradient);
    // The planes turn to the rounded gradient, and part to hold what lay between them.
    const float parting = Parting(planes.gradient, f16tof32(halves), blockTexels);
    const float nearest = DepthGap(planes.nearest, kFarthestDepth) + parting;
    const float farthest = DepthGap(planes.farthest, kFarthestDepth) - parting;
    const float steps = ceil((nearest + kBoundRange) * kBoundSteps);
    const float thickness = steps / kBoundSteps - kBoundRange - farthest + kPlanesRounding;
    const bool known = steps >= 0.0 && steps < 2.0 * kBoundSteps && thickness < 2.0;
    // Conversion may round to either side, so one step is added before the last three bits are rounded up.
    const uint stored = (f32tof16(known ? thickness : 0.0) + 8) >> 3;
    return uint2(known ? halves.x | (halves.y << 16) : 0, known ? (uint(steps) << 12) | stored : kUnknownBound);
}

DepthPlanes UnpackBounds(uint2 packed)
{
    const float nearest = float(packed.y >> 12) / kBoundSteps - kBoundRange;
    const float thickness = f16tof32((packed.y & 0xfffu) << 3);
    DepthPlanes planes;
    planes.gradient = float2(f16tof32(packed.x & 0xffffu), f16tof32(packed.x >> 16));
    planes.nearest = MoveTowardLight(kFarthestDepth, nearest);
    planes.farthest = MoveTowardLight(kFarthestDepth, nearest - thickness);
    return planes;
}

#endif
