// Penumbra: the part of a ray that lies in a box.
//
// Computes:   RayThroughBox: from where to where along the ray, empty (the second not above the first) where it misses
// Source:     slabs, Kay and Kajiya, "Ray Tracing Complex Scenes" (1986). A ray that runs along a slab lies in it or
//             not.
// Inputs:     the ray's origin and direction, the box's smallest and largest corner, how far the ray goes.
// Cost:       no fetches.
// Guarantees: both numbers are finite, >= 0 and at most the ray's length; a ray or box that is not finite misses.
// Use it:     before marching through a volume. Not: for boxes that are turned; turn the ray.
#ifndef PENUMBRA_RAY_BOX_HLSL
#define PENUMBRA_RAY_BOX_HLSL

#include "FloatBits.hlsl"

// Both ends of the part within one axis's slab, in the order in which the ray passes them.
float2 RayThroughSlab(float origin, float direction, float low, float high)
{
    if (abs(direction) < 1e-20) return origin >= low && origin <= high ? float2(-3e38, 3e38) : float2(3e38, -3e38);
    const float a = (low - origin) / direction;
    const float b = (high - origin) / direction;
    return float2(min(a, b), max(a, b));
}

float2 RayThroughBox(float3 origin, float3 direction, float3 low, float3 high, float length)
{
    const float2 x = RayThroughSlab(origin.x, direction.x, low.x, high.x);
    const float2 y = RayThroughSlab(origin.y, direction.y, low.y, high.y);
    const float2 z = RayThroughSlab(origin.z, direction.z, low.z, high.z);
    const float most = BoundedOrLow(length, 0.0, 1e9);
    const float from = max(max(x.x, y.x), max(z.x, 0.0));
    const float to = min(min(x.y, y.y), min(z.y, most));
    const bool meets = from < to && HasFiniteBits(from) && HasFiniteBits(to);
    const float sum = origin.x + origin.y + origin.z + direction.x + direction.y + direction.z;
    return meets && HasFiniteBits(sum) ? float2(from, to) : float2(0.0, 0.0);
}

#endif
