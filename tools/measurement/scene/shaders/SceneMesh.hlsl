// Penumbra tools: the scene's triangles, pulled by vertex number.
//
// Computes:   position and vertex normal of corner `vertex` of the triangle list.
// Inputs:     positions and normals as packed floats (three per vertex), metres, relative to the scene's origin;
//             three indices per triangle.
// Cost:       seven buffer loads.
// Guarantees: none beyond the mesh's own: the host checks that indices are in range.
// Use it:     from the vertex shaders of this folder.
#ifndef PENUMBRA_SCENE_MESH_HLSL
#define PENUMBRA_SCENE_MESH_HLSL

StructuredBuffer<float> _Positions;
StructuredBuffer<float> _Normals;
StructuredBuffer<uint> _Indices;

float3 CornerPosition(uint corner)
{
    const uint first = 3 * _Indices[corner];
    return float3(_Positions[first], _Positions[first + 1], _Positions[first + 2]);
}

float3 CornerNormal(uint corner)
{
    const uint first = 3 * _Indices[corner];
    return float3(_Normals[first], _Normals[first + 1], _Normals[first + 2]);
}

#endif
