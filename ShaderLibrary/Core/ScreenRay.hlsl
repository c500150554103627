// Penumbra: a straight line in world space as the camera's picture has it.
//
// Computes:   (u, v, stored depth) along a ray from a point that the camera sees, and how far a ray stays in the
//             picture.
// Source:     McGuire and Mara, "Efficient GPU Screen-Space Ray Tracing" (JCGT 2014): a projection maps straight lines
//             to straight lines. With h = M (u, v, depth, 1), J the tangents at the origin and D the direction, the
//             line is origin + slope s, where slope = J^-1 D per metre and s = t / (1 + bend t) after t metres; bend =
//             -(last row of M . slope) / h.w is by how much the depth along the view grows per metre, as a share.
// Inputs:     screenToWorld as in ScreenPosition.hlsl, at: its ScreenPoint at origin; direction: unit, world space.
// Cost:       no fetches.
// Guarantees: exact for projections of both kinds, whatever the direction of depth and the order of rows; no inverse of
//             a matrix, so that the distance from the world's origin has no effect of its own.
// Use it:     to walk over the camera's depth texture with equal steps over the screen.
#ifndef PENUMBRA_SCREEN_RAY_HLSL
#define PENUMBRA_SCREEN_RAY_HLSL

#include "ScreenPosition.hlsl"

struct ScreenRay
{
    float3 origin; // (u, v, stored depth)
    float3 slope;  // their change per metre, at the origin
    float bend;    // 1 / metre
};

ScreenRay ScreenRayOf(float4x4 screenToWorld, ScreenPoint at, float3 origin, float3 direction)
{
    const float3 alongU = ScreenTangent(screenToWorld, at, float3(1.0, 0.0, 0.0));
    const float3 alongV = ScreenTangent(screenToWorld, at, float3(0.0, 1.0, 0.0));
    const float3 alongDepth = ScreenTangent(screenToWorld, at, float3(0.0, 0.0, 1.0));
    const float3 acrossU = cross(alongV, alongDepth);
    const float3 acrossV = cross(alongDepth, alongU);
    const float3 acrossDepth = cross(alongU, alongV);
    ScreenRay ray;
    ray.origin = origin;
    ray.slope = float3(dot(direction, acrossU), dot(direction, acrossV), dot(direction, acrossDepth)) /
                dot(alongU, acrossU);
    ray.bend = -dot(screenToWorld[3].xyz, ray.slope) * at.inverseW;
    return ray;
}

float3 ScreenRayPoint(ScreenRay ray, float along)
{
    return ray.origin + ray.slope * along;
}

// Takes metres to s; ScreenRayMetres takes them back. A ray that reaches the camera's own plane before `metres` has no
// end, so it gets a length beyond any picture.
float ScreenRayAlong(ScreenRay ray, float metres)
{
    const float growth = 1.0 + ray.bend * metres;
    return growth > 1e-6 ? metres / growth : 1e6 * metres;
}

float ScreenRayMetres(ScreenRay ray, float along)
{
    return along / (1.0 - ray.bend * along);
}

// The largest s up to `along` at which a coordinate that begins within [0, 1] is still within it.
float WithinUnit(float origin, float slope, float along)
{
    const float end = slope > 0.0 ? 1.0 : 0.0;
    const float reach = (end - origin) / (slope == 0.0 ? 1.0 : slope);
    return slope == 0.0 ? along : min(along, max(reach, 0.0));
}

// The largest s up to `along` at which the ray is still within the picture, in front of the camera's far plane and
// behind its near plane.
float ScreenRayWithin(ScreenRay ray, float along)
{
    along = WithinUnit(ray.origin.x, ray.slope.x, along);
    along = WithinUnit(ray.origin.y, ray.slope.y, along);
    return WithinUnit(ray.origin.z, ray.slope.z, along);
}

#endif
