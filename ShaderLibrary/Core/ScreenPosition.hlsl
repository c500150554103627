// Penumbra: from a pixel and its camera depth to world space.
//
// Computes:   the world position under a pixel, how it moves with the pixel, and the surface's normal from the depths
//             of its neighbours.
// Source:     the inverse view-projection as a projective map: with h = M (u, v, depth, 1) and position = h.xyz / h.w,
//             a step s of (u, v, depth) moves the position by (M s).xyz - position (M s).w, over h.w. Perspective
//             projection maps planes to planes, so stored depth changes linearly over the screen along a surface, and
//             the difference to a neighbour on the same surface is its exact slope.
// Inputs:     screenToWorld: (uv, stored camera depth, 1), a column vector, to homogeneous world metres. The
//             matrix accounts for the direction of depth, the origin of v and the projection.
// Cost:       no fetches.
// Guarantees: a depth of 0, 1 or NaN is not a surface, in either convention: one is the sky, the other the near plane,
//             on which nothing is drawn. A normal has unit length or is 0, never NaN. Positions are finite if the
//             matrix is invertible.
// Use it:     in screen passes. Not: with view-space or linear depth.
#ifndef PENUMBRA_SCREEN_POSITION_HLSL
#define PENUMBRA_SCREEN_POSITION_HLSL

#include "FloatBits.hlsl"

struct ScreenPoint
{
    float3 positionWS;
    float inverseW; // 1 / h.w
};

bool IsSurfaceDepth(float depth)
{
    return !HasNanBits(depth) && depth > 0.0 && depth < 1.0;
}

ScreenPoint ScreenPointOf(float4x4 screenToWorld, float2 uv, float depth)
{
    const float4 h = mul(screenToWorld, float4(uv, depth, 1.0));
    ScreenPoint at;
    at.inverseW = 1.0 / h.w;
    at.positionWS = h.xyz * at.inverseW;
    return at;
}

// The position's movement, metres, for a small move of (u, v, depth), to first order.
float3 ScreenTangent(float4x4 screenToWorld, ScreenPoint at, float3 move)
{
    const float4 h = mul(screenToWorld, float4(move, 0.0));
    return (h.xyz - at.positionWS * h.w) * at.inverseW;
}

// Width of a pixel at this distance, metres, in the plane of equal depth: nothing seen there is nearer to its
// neighbour than this. pixelSize: 1 / width, 1 / height of the screen.
float MetresPerPixel(float4x4 screenToWorld, ScreenPoint at, float2 pixelSize)
{
    const float3 alongX = ScreenTangent(screenToWorld, at, float3(pixelSize.x, 0.0, 0.0));
    const float3 alongY = ScreenTangent(screenToWorld, at, float3(0.0, pixelSize.y, 0.0));
    return sqrt(min(dot(alongX, alongX), dot(alongY, alongY)));
}

// Larger than any slope between depths in [0, 1]: means "not known".
static const float kNoDepthSlope = 2.0;

// Depths of three pixels in a row.
struct DepthLine
{
    float before;
    float here; // a surface
    float after;
};

// Change of depth to the next pixel on either side: x from the one before, y to the one after.
float2 DepthSlopes(DepthLine along)
{
    return float2(IsSurfaceDepth(along.before) ? along.here - along.before : kNoDepthSlope,
                  IsSurfaceDepth(along.after) ? along.after - along.here : kNoDepthSlope);
}

// The slope on the side that changes less; kNoDepthSlope when neither neighbour is a surface.
float NearerSlope(DepthLine along)
{
    const float2 slopes = DepthSlopes(along);
    return abs(slopes.y) < abs(slopes.x) ? slopes.y : slopes.x;
}

// Whether the pixels belong to two surfaces or to a sharp bend: the slopes then differ by more than a sixteenth, many
// times the effect of rounding on depths far from the camera.
bool ContradictsItself(DepthLine along)
{
    const float2 slopes = DepthSlopes(along);
    const float steeper = max(abs(slopes.x), abs(slopes.y));
    return steeper < kNoDepthSlope && abs(slopes.x - slopes.y) > 0.0625 * steeper;
}

// The slope on the side on which depth continues linearly, as it does on a plane. A side without a second neighbour is
// assumed to bend by half the difference between the two slopes, so it loses to a straight line and wins against an
// edge. If both bend equally, the side that changes less is taken.
float StraighterSlope(float before2, DepthLine along, float after2)
{
    const float2 slopes = DepthSlopes(along);
    const float unknown = 0.5 * abs(slopes.x - slopes.y);
    const float bendBefore = IsSurfaceDepth(before2) ? abs(along.before - before2 - slopes.x) : unknown;
    const float bendAfter = IsSurfaceDepth(after2) ? abs(after2 - along.after - slopes.y) : unknown;
    if (bendBefore == bendAfter) return NearerSlope(along);
    return bendBefore < bendAfter ? slopes.x : slopes.y;
}

// The unit normal; 0 where a slope is not known. slope: change of depth per pixel to the right and down the rows. The
// normal's sign follows the matrix: flip it where it matters.
float3 ScreenNormal(float4x4 screenToWorld, ScreenPoint at, float2 slope, float2 pixelSize)
{
    if (!(abs(slope.x) <= 1.0) || !(abs(slope.y) <= 1.0)) return float3(0.0, 0.0, 0.0);
    const float3 alongX = ScreenTangent(screenToWorld, at, float3(pixelSize.x, 0.0, slope.x));
    const float3 alongY = ScreenTangent(screenToWorld, at, float3(0.0, pixelSize.y, slope.y));
    const float3 x = alongX / max(length(alongX), 1e-20);
    const float3 y = alongY / max(length(alongY), 1e-20);
    const float3 across = cross(x, y);
    const float squared = dot(across, across);
    if (!HasFiniteBits(squared) || !(squared > 1e-12)) return float3(0.0, 0.0, 0.0);
    return across / sqrt(squared);
}

// 1 on the plane through the surface, falling to 0 at a distance of `tolerance` metres. offset: to the other point.
float PlaneWeight(float3 offset, float3 normalWS, float tolerance)
{
    const float beside = abs(dot(offset, normalWS));
    if (!HasFiniteBits(beside) || !(beside < tolerance)) return 0.0;
    return 1.0 - beside / tolerance;
}

#endif
