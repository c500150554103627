// Penumbra: shadows of several objects from their distance fields.
//
// Computes:   FieldSceneHardVisibility  0 where a ray towards the light meets an object, else 1
//             FieldSceneConeVisibility  the share of a disc light that the objects leave free, by a cone for each
//             FieldSceneSoftVisibility  the same, by six more cones in each object's penumbra
// Source:     DistanceFieldMarch.hlsl. What two objects leave free of a disc lies between max(0, a + b - 1), where they
//             cover different parts of it, and min(a, b), where they cover the same part. Which it is, the six parts of
//             the disc tell for the most part: of each part the least over the objects is free. With one cone each, the
//             shares are multiplied, as if one said nothing about the other. Documentation~/other-shadows.md compares
//             the ways.
// Inputs:     a 3D texture in which each object has a part, of `penumbra bake distance-field --objects N`; world
//             positions and the surface's normal, in metres; uniforms:
//             _PenumbraFieldAtlas   voxels of the JSON file, the texture's texels along x, y and z; the number of
//                                   objects
//             _PenumbraFieldObjects six rows for each object: three that take a world position to the field's own
//             space, which
//                                   may be turned, moved and scaled alike along all axes; then, of the object's entry
//                                   in the file, corner_metres and distances_metres[1]; size_metres and a voxel's edge,
//                                   size_metres[0] / voxels[0]; first_voxel. Lengths but for the first three rows are
//                                   those of the field's own space. Documentation~/far-shadows.md sets them from C#.
//             They are constants, not a buffer, so that OpenGL ES 3.0 and WebGL 2 have them.
// Cost:       for each object about 30 operations where its box is beside the ray or cone; else
//             DistanceFieldMarch.hlsl's.
// Guarantees: [0, 1] for any input; at most 16 objects. An object whose rows are not finite casts nothing. Texels of
//             one object have no weight for another. Rays begin a voxel above the surface along its normal.
// Use it:     for up to 16 solid objects that a shadow map does not hold, or holds too coarsely. Not: for sheets, wires
//             and leaves, which are thinner than two voxels.
#ifndef PENUMBRA_DISTANCE_FIELD_SCENE_HLSL
#define PENUMBRA_DISTANCE_FIELD_SCENE_HLSL

#include "DistanceFieldMarch.hlsl"

#define PENUMBRA_MOST_FIELD_OBJECTS 16

float4 _PenumbraFieldAtlas;
float4 _PenumbraFieldObjects[6 * PENUMBRA_MOST_FIELD_OBJECTS];

// A ray towards the light in an object's own space.
struct FieldRay
{
    float3 origin;
    float3 direction;
    float farthest;
    DistanceFieldBox box;
};

int FieldObjectCount()
{
    return int(BoundedOrLow(_PenumbraFieldAtlas.w, 0.0, float(PENUMBRA_MOST_FIELD_OBJECTS)));
}

FieldRay RayOfFieldObject(int object, float3 positionWS, float3 normalWS, float3 towardLight, float farthest)
{
    const float4 x = _PenumbraFieldObjects[6 * object];
    const float4 y = _PenumbraFieldObjects[6 * object + 1];
    const float4 z = _PenumbraFieldObjects[6 * object + 2];
    FieldRay ray;
    ray.box = BoundedFieldPart(_PenumbraFieldObjects[6 * object + 3], _PenumbraFieldObjects[6 * object + 4],
                               _PenumbraFieldObjects[6 * object + 5].xyz, _PenumbraFieldAtlas.xyz);
    const float3 position = float3(dot(x.xyz, positionWS), dot(y.xyz, positionWS), dot(z.xyz, positionWS));
    const float3 normal = float3(dot(x.xyz, normalWS), dot(y.xyz, normalWS), dot(z.xyz, normalWS));
    const float3 direction = float3(dot(x.xyz, towardLight), dot(y.xyz, towardLight), dot(z.xyz, towardLight));
    const float scale = length(direction);
    ray.origin = position + float3(x.w, y.w, z.w) + ray.box.voxelMetres * normal / scale;
    ray.direction = direction / scale;
    ray.farthest = farthest * scale;
    return ray;
}

float FieldSceneHardVisibility(TEXTURE3D(atlas), SAMPLER(sampler_linear), float3 positionWS, float3 normalWS,
                               float3 towardLight, float farthest, int steps)
{
    const int count = FieldObjectCount();
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        const FieldRay ray = RayOfFieldObject(i, positionWS, normalWS, towardLight, farthest);
        if (FieldHardVisibility(TEXTURE3D_ARGS(atlas, sampler_linear), ray.origin, ray.direction, ray.farthest, steps,
                                ray.box) <= 0.0)
        {
            return 0.0;
        }
    }
    return 1.0;
}

float FieldSceneConeVisibility(TEXTURE3D(atlas), SAMPLER(sampler_linear), float3 positionWS, float3 normalWS,
                               float3 towardLight, float farthest, float tanHalf, int steps)
{
    float free = 1.0;
    const int count = FieldObjectCount();
    UNITY_LOOP
    for (int i = 0; i < count && free > 0.0; ++i)
    {
        const FieldRay ray = RayOfFieldObject(i, positionWS, normalWS, towardLight, farthest);
        free *= FieldConeVisibility(TEXTURE3D_ARGS(atlas, sampler_linear), ray.origin, ray.direction, ray.farthest,
                                    tanHalf, steps, ray.box);
    }
    return free;
}

float FieldSceneSoftVisibility(TEXTURE3D(atlas), SAMPLER(sampler_linear), float3 positionWS, float3 normalWS,
                               float3 towardLight, float farthest, float tanHalf, int steps)
{
    FieldParts free = EqualParts(1.0);
    const int count = FieldObjectCount();
    UNITY_LOOP
    for (int i = 0; i < count && MeanOfParts(free) > 0.0; ++i)
    {
        const FieldRay ray = RayOfFieldObject(i, positionWS, normalWS, towardLight, farthest);
        const FieldParts parts = FieldPartsVisibility(TEXTURE3D_ARGS(atlas, sampler_linear), ray.origin, ray.direction,
                                                      ray.farthest, tanHalf, steps, ray.box);
        free.first = min(free.first, parts.first);
        free.second = min(free.second, parts.second);
    }
    return MeanOfParts(free);
}

#endif
