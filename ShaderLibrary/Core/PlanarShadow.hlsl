// Penumbra: shadows flattened onto a plane.
//
// Computes:   OntoPlane: where the ray from a light through a point of the caster meets a plane
// Source:     Blinn, "Me and my (fake) shadow" (1988), for the sun and for a point light.
// Inputs:     a point of the caster; the plane: unit normal, and the distance that the normal times a point of the
//             plane is; the light: direction towards it and 0, or its position and 1; metres.
// Cost:       no fetches; the vertices of the caster once more.
// Guarantees: finite for any input. `valid` is false where there is no shadow: the point under the plane, or not under
//             the light. Triangles with a corner that is not valid are to be left out, or drawn where the caster
//             stands.
// Use it:     for flat ground and few casters, with HeightFade.hlsl and a stencil bit so that no pixel darkens twice.
//             Not: for ground that is not flat; nor where the plane ends, since the shadow does not.
#ifndef PENUMBRA_PLANAR_SHADOW_HLSL
#define PENUMBRA_PLANAR_SHADOW_HLSL

#include "FloatBits.hlsl"

struct PlanarPoint
{
    float3 position;
    float height; // height of the caster's point over the plane, metres
    bool valid;
};

PlanarPoint OntoPlane(float3 position, float4 plane, float4 light)
{
    PlanarPoint result;
    result.position = position;
    const float height = dot(plane.xyz, position) - plane.w;
    const float3 towards = light.xyz - light.w * position;
    const float rise = dot(plane.xyz, towards); // how much the way to the light rises over the plane
    const float share = height / rise;
    const float3 place = position - share * towards;
    const float sum = place.x + place.y + place.z;
    result.valid = HasFiniteBits(sum) && height >= 0.0 && rise > 0.0 && abs(share) < 1e6;
    result.height = BoundedOrLow(height, 0.0, 1e6);
    if (result.valid) result.position = place;
    else result.position = float3(FiniteOr(position.x, 0.0), FiniteOr(position.y, 0.0), FiniteOr(position.z, 0.0));
    return result;
}

#endif
