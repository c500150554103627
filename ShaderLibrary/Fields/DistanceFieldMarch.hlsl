// Penumbra: shadows of an object from its distance field.
//
// Computes:   FieldHardVisibility  0 where a ray towards the light meets the object, else 1
//             FieldConeVisibility  the share of a disc light that the object leaves free, by one cone
//             FieldPartsVisibility that of each of six parts of the disc, by one cone and by six narrower ones in its
//             penumbra
//             FieldSoftVisibility  the mean of the parts
// Source:     sphere tracing, Hart, "Sphere Tracing" (1996); cones as in Quilez, "Free penumbra shadows for raymarching
//             distance fields" (2010). The least of d / t over a ray, with the field's distance d at a length t, is the
//             sine of the widest cone about the ray that the object leaves free. The edge that this cone touches is
//             taken as straight: the share of the disc beyond it is free. Quilez has clamp(d / r, 0, 1) instead, for
//             which all rays that meet the object are dark: half of the penumbra is missing, that inside of the hard
//             shadow's edge. Where a ray passes through the object, d is how deep. Of a chord of half length c that is
//             d deep at its deepest place, the nearest edge is d / sqrt(1 - (d / c)^2) beside the ray if it is a
//             wedge's. It is farther away if the object is a plate, for which c and d say nothing; the larger d / c,
//             the more the free cones beside it count, of which each says how near the edge is at most.
// Inputs:     field: a 3D texture of `penumbra bake distance-field`, a stored 0 the first of distances_metres, a stored
//             1 the second; box: BoundedFieldBox(float4(corner_metres, distances_metres[1]), float4(size_metres,
//             edge)), with the numbers of the bake's JSON file and edge = size_metres[0] / voxels[0]; the ray in the
//             field's own space, in metres: where it begins, its unit direction, how far it goes; tan of half the
//             light's angular diameter; how many steps each ray and each cone goes at the most.
//             Documentation~/far-shadows.md has an example.
// Cost:       a filtered fetch of a 3D texture for each step; none for a ray or cone that misses the box. The six cones
//             begin where the one about them is touched, and only if it is neither free nor covered.
// Guarantees: [0, 1] for any input; at most 256 steps of each cone; texels of other parts of the texture have no
//             weight; the hard test never reports a surface nearer than a quarter voxel where there is none. For a ray
//             that runs out of steps, only what the steps so far have met counts: beyond, nothing casts. Cones are
//             wider than the box: there the distance is a lower bound of the distance to the object, so that a step
//             never passes through it.
// Use it:     for objects without a shadow map. Not: for anything thinner than two voxels, which a field does not hold.
#ifndef PENUMBRA_DISTANCE_FIELD_MARCH_HLSL
#define PENUMBRA_DISTANCE_FIELD_MARCH_HLSL

#include "../Platform/Platform.hlsl"
#include "../Core/DiscHorizon.hlsl"
#include "../Core/RayBox.hlsl"

// The radius of a ring, within the unit disc, with six discs on it. For every direction and place of a straight edge,
// the mean of the shares that the edge leaves of the six discs is that of the unit disc within 0.014.
static const float kConeRing = 0.62;
static const float kConeRadius = 0.51;
static const float2 kConePlaces[6] = {float2(0.8660254, 0.5), float2(0.0, 1.0), float2(-0.8660254, 0.5),
                                      float2(-0.8660254, -0.5), float2(0.0, -1.0), float2(0.8660254, -0.5)};

struct DistanceFieldBox
{
    float3 corner;       // smallest x, y and z, metres
    float3 size;         // metres
    float largestMetres; // distance that a stored 1 means; a stored 0 is as far inside
    float voxelMetres;   // edge of a voxel
    float3 first;        // texture coordinates of the corner
    float3 extent;       // texture coordinates from the corner to the opposite one
    float3 inset;        // texture coordinates from the border to the outermost centres of voxels
};

// A box whose voxels are a part of a texture that is `texels` wide; the part begins at the voxel `first`. corner.w
// holds the largest distance, size.w the voxel's edge.
DistanceFieldBox BoundedFieldPart(float4 corner, float4 size, float3 first, float3 texels)
{
    DistanceFieldBox box;
    box.corner = BoundedOrLow(corner.xyz, -1e6, 1e6);
    box.size = BoundedOrLow(size.xyz, 1e-4, 1e6);
    box.largestMetres = BoundedOrLow(corner.w, 1e-5, 1e6);
    box.voxelMetres = BoundedOrLow(size.w, 1e-5, 1e6);
    const float3 all = BoundedOrLow(texels, 1.0, 16384.0);
    box.first = BoundedOrLow(first, 0.0, 16384.0) / all;
    box.extent = BoundedOrLow(floor(box.size / box.voxelMetres + 0.5), 1.0, 16384.0) / all;
    // The inset is half a voxel and a little more, so that no rounding of the coordinate gives weight to a texel beyond
    // the border.
    box.inset = 0.50390625 / all;
    return box;
}

// A box with a texture of its own.
DistanceFieldBox BoundedFieldBox(float4 corner, float4 size)
{
    const float voxel = BoundedOrLow(size.w, 1e-5, 1e6);
    return BoundedFieldPart(corner, size, float3(0.0, 0.0, 0.0), floor(size.xyz / voxel + 0.5));
}

// The distance in metres, negative inside the object. Outside of the box it is a lower bound: the way from the nearest
// place of the box out to the position meets the way to any place in the box at a right angle or more.
float FieldDistance(TEXTURE3D(field), SAMPLER(sampler_linear), float3 position, DistanceFieldBox box)
{
    const float3 wanted = (position - box.corner) / box.size * box.extent;
    const float3 inside = max(min(max(wanted, box.inset), box.extent - box.inset), 0.0);
    const float stored = SAMPLE_TEXTURE3D_LOD(field, sampler_linear, box.first + inside, 0.0).r;
    const float distance = box.largestMetres * (2.0 * BoundedOrLow(stored, 0.0, 1.0) - 1.0);
    const float3 beside = (wanted - inside) / box.extent * box.size;
    const float squared = dot(beside, beside);
    return squared > 0.0 && distance > 0.0 ? sqrt(squared + distance * distance) : distance;
}

float FieldHardVisibility(TEXTURE3D(field), SAMPLER(sampler_linear), float3 origin, float3 direction, float farthest,
                          int steps, DistanceFieldBox box)
{
    const float2 inside = RayThroughBox(origin, direction, box.corner, box.corner + box.size, farthest);
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

// The part of a ray on which a cone about the ray may meet the box; spread is the cone's radius per length.
float2 ConeThroughBox(float3 origin, float3 direction, float farthest, float spread, DistanceFieldBox box)
{
    const float3 middle = box.corner + 0.5 * box.size - origin;
    const float behind = dot(middle, direction) + 0.5 * length(box.size);
    const float wider = spread * BoundedOrLow(behind, 0.0, BoundedOrLow(farthest, 0.0, 1e9));
    return RayThroughBox(origin, direction, box.corner - wider, box.corner + box.size + wider, farthest);
}

// The edge that a cone meets, and where.
struct FieldCone
{
    float edge;     // the object's edge over the disc's middle, in radii of the disc: -1 is free, 1 covered
    float flatness; // greatest depth of the chord within the object as a share of its half length; 0 without a chord
    float2 touched; // the part of the ray on which the object is within the cone
};

FieldCone MarchedCone(TEXTURE3D(field), SAMPLER(sampler_linear), float3 origin, float3 direction, float2 range,
                      float spread, int most, DistanceFieldBox box)
{
    FieldCone cone;
    cone.flatness = 0.0;
    cone.touched = float2(range.y, range.x);
    float t = max(range.x, 1e-4 * box.voxelMetres);
    float last = t;        // length at the step before
    float distance = 1e9;  // the field's distance at that step
    float free = spread;   // the least of distance / t
    float entered = 0.0;   // where the chord begins
    float deepest = 0.0;   // greatest depth on the chord
    UNITY_LOOP
    for (int i = 0; i < most && t < range.y && free > -spread; ++i)
    {
        const float before = distance;
        distance = FieldDistance(TEXTURE3D_ARGS(field, sampler_linear), origin + t * direction, box);
        if (distance < spread * t) cone.touched.x = min(cone.touched.x, last);
        // The surface lies here if there is one between both steps.
        const float crossed = t - (t - last) * abs(distance) / max(abs(distance) + abs(before), 1e-9);
        if (distance < 0.0)
        {
            entered = before < 0.0 ? entered : crossed;
            deepest = max(deepest, -distance);
            free = min(free, -deepest / t);
        }
        else
        {
            if (deepest > 0.0)
            {
                const float flatness = min(2.0 * deepest / max(crossed - entered, 1e-6), 1.0);
                cone.flatness = max(cone.flatness, flatness);
                free = min(free, -deepest / (t * sqrt(max(1.0 - flatness * flatness, 1e-4))));
            }
            deepest = 0.0;
            free = min(free, distance / t);
        }
        if (distance < spread * t) cone.touched.y = t;
        last = t;
        // Before the next step nothing is nearer than what is known. Inside the object, the way out is as long as the
        // depth.
        t += max(max((distance - free * t) / (1.0 + free), 0.5 * abs(distance)), 0.5 * box.voxelMetres);
    }
    cone.touched.y = min(max(cone.touched.y, t), range.y);
    cone.edge = -free / spread;
    return cone;
}

float FieldConeVisibility(TEXTURE3D(field), SAMPLER(sampler_linear), float3 origin, float3 direction, float farthest,
                          float tanHalf, int steps, DistanceFieldBox box)
{
    const float spread = BoundedOrLow(tanHalf, 1e-5, 0.9);
    const float2 range = ConeThroughBox(origin, direction, farthest, spread, box);
    return DiscShareAbove(MarchedCone(TEXTURE3D_ARGS(field, sampler_linear), origin, direction, range, spread,
                                      min(max(steps, 1), 256), box).edge);
}

// The shares of the six parts of the disc that an object leaves free.
struct FieldParts
{
    float3 first;
    float3 second;
};

float MeanOfParts(FieldParts parts)
{
    return dot(parts.first + parts.second, 1.0 / 6.0);
}

FieldParts EqualParts(float share)
{
    FieldParts parts;
    parts.first = float3(share, share, share);
    parts.second = parts.first;
    return parts;
}

FieldParts FieldPartsVisibility(TEXTURE3D(field), SAMPLER(sampler_linear), float3 origin, float3 direction,
                                float farthest, float tanHalf, int steps, DistanceFieldBox box)
{
    const float spread = BoundedOrLow(tanHalf, 1e-5, 0.9);
    const int most = min(max(steps, 1), 256);
    const float2 range = ConeThroughBox(origin, direction, farthest, spread, box);
    const FieldCone all = MarchedCone(TEXTURE3D_ARGS(field, sampler_linear), origin, direction, range, spread, most,
                                      box);
    const float one = DiscShareAbove(all.edge);
    if (one <= 0.0 || one >= 1.0) return EqualParts(one);
    // This orthonormal basis is that of Duff et al., "Building an Orthonormal Basis, Revisited" (2017).
    const float side = direction.z < 0.0 ? -1.0 : 1.0;
    const float scale = -1.0 / (side + direction.z);
    const float both = direction.x * direction.y * scale;
    const float3 right = float3(1.0 + side * direction.x * direction.x * scale, side * both, -side * direction.x);
    const float3 up = float3(both, side + direction.y * direction.y * scale, -direction.y);
    float edges[6];
    float flatness[6];
    UNITY_LOOP
    for (int i = 0; i < 6; ++i)
    {
        const float2 place = kConeRing * spread * kConePlaces[i];
        const FieldCone cone = MarchedCone(TEXTURE3D_ARGS(field, sampler_linear), origin,
                                           normalize(direction + place.x * right + place.y * up), all.touched,
                                           kConeRadius * spread, most, box);
        edges[i] = kConeRadius * cone.edge;
        flatness[i] = cone.flatness;
    }
    float free[6];
    for (int j = 0; j < 6; ++j)
    {
        float edge = edges[j];
        if (edge > 0.0)
        {
            // The edge is no farther away than a free circle about the middle of another cone.
            float least = all.edge < 0.0 ? kConeRing + all.edge : 2.0;
            for (int k = 0; k < 6; ++k)
            {
                const float apart = kConeRing * length(kConePlaces[j] - kConePlaces[k]);
                least = edges[k] < 0.0 ? min(least, apart + edges[k]) : least;
            }
            edge += flatness[j] * flatness[j] * max(least - edge, 0.0);
        }
        free[j] = DiscShareAbove(edge / kConeRadius);
    }
    FieldParts parts;
    parts.first = float3(free[0], free[1], free[2]);
    parts.second = float3(free[3], free[4], free[5]);
    return parts;
}

float FieldSoftVisibility(TEXTURE3D(field), SAMPLER(sampler_linear), float3 origin, float3 direction, float farthest,
                          float tanHalf, int steps, DistanceFieldBox box)
{
    return MeanOfParts(FieldPartsVisibility(TEXTURE3D_ARGS(field, sampler_linear), origin, direction, farthest, tanHalf,
                                            steps, box));
}

#endif
