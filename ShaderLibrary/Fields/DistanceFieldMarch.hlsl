// Penumbra: shadows of an object from its distance field.
//
// Computes:   FieldHardVisibility  0 where a ray towards the light meets the object, else 1
//             FieldSoftVisibility  the share of a disc light that the object leaves free
// Source:     sphere tracing, Hart, "Sphere Tracing" (1996). The soft share is that above a straight edge which passes the ray
//             at the field's distance d, in a cone of radius r = t tan(a / 2) at a length t of the ray: the least over the ray of
//             the disc's share above -d / r. Quilez, "Free penumbra shadows for raymarching distance fields" (2010), has
//             clamp(d / r, 0, 1) instead, for which half of the penumbra is missing: that inside of the hard shadow's edge.
// Inputs:     field: a 3D texture of `penumbra bake distance-field`; DistanceFieldBox; the ray in the field's own space, in
//             metres: where it begins, its unit direction, how far it goes; tan of half the light's angular diameter; steps.
// Cost:       a filtered fetch of a 3D texture for each step inside of the box; none for a ray that misses it.
// Guarantees: [0, 1] for any input; at most 256 steps; the hard test never reports a surface nearer than a quarter voxel where
//             there is none. A ray that runs out of steps inside of the box is lit as far as it has come.
// Use it:     for objects without a shadow map, few and convex enough. Not: for several occluders in one cone: their shares are
//             not added, the least counts; nor for anything thinner than a voxel.
#ifndef PENUMBRA_DISTANCE_FIELD_MARCH_HLSL
#define PENUMBRA_DISTANCE_FIELD_MARCH_HLSL

#include "../Platform/Platform.hlsl"
#include "../Core/DiscHorizon.hlsl"
#include "../Core/RayBox.hlsl"

struct DistanceFieldBox
{
    float3 corner;       // metres, the smallest of each
    float3 size;         // metres
    float largestMetres; // distance of a stored 1; a stored 0 is as far inside
    float voxelMetres;   // edge of a voxel
};

// corner.w: the largest distance. size.w: the voxel's edge.
DistanceFieldBox BoundedFieldBox(float4 corner, float4 size)
{
    DistanceFieldBox box;
    box.corner = float3(BoundedOrLow(corner.x, -1e6, 1e6), BoundedOrLow(corner.y, -1e6, 1e6), BoundedOrLow(corner.z, -1e6, 1e6));
    box.size = float3(BoundedOrLow(size.x, 1e-4, 1e6), BoundedOrLow(size.y, 1e-4, 1e6), BoundedOrLow(size.z, 1e-4, 1e6));
    box.largestMetres = BoundedOrLow(corner.w, 1e-5, 1e6);
    box.voxelMetres = BoundedOrLow(size.w, 1e-5, 1e6);
    return box;
}

float FieldDistance(TEXTURE3D(field), SAMPLER(sampler_linear), float3 position, DistanceFieldBox box)
{
    const float3 coordinate = (position - box.corner) / box.size;
    const float stored = SAMPLE_TEXTURE3D_LOD(field, sampler_linear, coordinate, 0.0).r;
    return box.largestMetres * (2.0 * BoundedOrLow(stored, 0.0, 1.0) - 1.0);
}

float FieldHardVisibility(TEXTURE3D(field), SAMPLER(sampler_linear), float3 origin, float3 direction, float length, int steps,
                          DistanceFieldBox box)
{
    const float2 inside = RayThroughBox(origin, direction, box.corner, box.corner + box.size, length);
    float t = inside.x;
    const int most = min(max(steps, 1), 256);
    UNITY_LOOP
    for (int i = 0; i < most && t < inside.y; ++i)
    {
        const float distance = FieldDistance(TEXTURE3D_ARGS(field, sampler_linear), origin + t * direction, box);
        if (distance < 0.25 * box.voxelMetres) return 0.0;
        t += max(distance, 0.25 * box.voxelMetres);
    }
    return 1.0;
}

float FieldSoftVisibility(TEXTURE3D(field), SAMPLER(sampler_linear), float3 origin, float3 direction, float length,
                          float tanHalf, int steps, DistanceFieldBox box)
{
    const float2 inside = RayThroughBox(origin, direction, box.corner, box.corner + box.size, length);
    const float spread = BoundedOrLow(tanHalf, 1e-5, 10.0);
    float t = max(inside.x, 1e-4 * box.voxelMetres);
    float visibility = 1.0;
    const int most = min(max(steps, 1), 256);
    UNITY_LOOP
    for (int i = 0; i < most && t < inside.y; ++i)
    {
        const float distance = FieldDistance(TEXTURE3D_ARGS(field, sampler_linear), origin + t * direction, box);
        visibility = min(visibility, DiscShareAbove(-distance / (t * spread)));
        if (visibility <= 0.0) return 0.0;
        // Inside of the object the way out is as long as the distance at the least, and the darkest place lies between.
        t += max(0.5 * abs(distance), 0.25 * box.voxelMetres);
    }
    return visibility;
}

#endif
