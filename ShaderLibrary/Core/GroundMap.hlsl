// Penumbra: places in a map of the ground, as far shadows read it.
//
// Computes:   GroundUv        texture coordinates of a place in the world
//             GroundCoverage  1 where the map has ground, 0 beside it
//             GroundHeight    metres of a stored height
// Source:     the layout of Unity's terrains: the first texel of heights lies at the smallest x and z, rows along +X.
// Inputs:     GroundMap, by BoundedGroundMap: world x and z of the map's corner, its size, and metres of 0 and 1; of a
//             bake's JSON file, float4(corner_metres, size_metres) and heights_metres. Horizon angles have no heights:
//             float2(0, 1).
// Cost:       no fetches.
// Guarantees: coordinates are finite for any place; coverage is 0 for a place that is not finite.
// Use it:     with bakes of `penumbra bake`, or a terrain's own height map. Not: for ground with overhangs.
#ifndef PENUMBRA_GROUND_MAP_HLSL
#define PENUMBRA_GROUND_MAP_HLSL

#include "FloatBits.hlsl"

struct GroundMap
{
    float2 corner; // metres, x and z
    float2 size;   // metres along x and z
    float low;     // metres of a stored height of 0
    float span;    // metres from a stored 0 to 1
};

// area: the corner's x and z, then the size. heights: metres of 0 and of 1.
GroundMap BoundedGroundMap(float4 area, float2 heights)
{
    GroundMap ground;
    ground.corner = float2(BoundedOrLow(area.x, -1e7, 1e7), BoundedOrLow(area.y, -1e7, 1e7));
    ground.size = float2(BoundedOrLow(area.z, 1e-3, 1e7), BoundedOrLow(area.w, 1e-3, 1e7));
    ground.low = BoundedOrLow(heights.x, -1e5, 1e5);
    ground.span = BoundedOrLow(heights.y - heights.x, 1e-3, 2e5);
    return ground;
}

// Coordinates in maps whose texels are parts of the area, such as horizon angles.
float2 GroundUv(float3 positionWS, GroundMap ground)
{
    const float2 place = float2(BoundedOrLow(positionWS.x, -1e8, 1e8), BoundedOrLow(positionWS.z, -1e8, 1e8));
    return (place - ground.corner) / ground.size;
}

// Coordinates in maps of heights, whose first and last texels lie on the area's edges; `texels` is their number each
// way.
float2 HeightUv(float2 groundUv, float2 texels)
{
    const float2 count = max(texels, 2.0);
    return (groundUv * (count - 1.0) + 0.5) / count;
}

float GroundCoverage(float3 positionWS, float2 groundUv)
{
    const bool2 inside = groundUv >= 0.0 && groundUv <= 1.0;
    const float sum = positionWS.x + positionWS.z;
    return inside.x && inside.y && FiniteOr(sum, 1.0) == sum ? 1.0 : 0.0;
}

float GroundHeight(float stored, GroundMap ground)
{
    return ground.low + ground.span * BoundedOrLow(stored, 0.0, 1.0);
}

#endif
