// Penumbra: the input of every filter: a pixel and its cascade.
//
// Computes:   nothing: it declares two structs and their units.
// Source:     the per-cascade scales follow from the world-to-shadow matrix M: uvPerMetre = |row0.xyz| of M divided
//             by the tile's extent, depthPerMetre = |row2.xyz|.
// Inputs:     -
// Cost:       none.
// Guarantees: -
// Use it:     fill them from your pipeline (Pipelines/Urp.hlsl does it for URP). Fields may hold anything,
//             infinities and NaN included: filters bound what they read.
#ifndef PENUMBRA_SHADOW_STRUCTS_HLSL
#define PENUMBRA_SHADOW_STRUCTS_HLSL

struct ShadowReceiver
{
    float3 shadowCoord;   // atlas UV, stored depth
    float2 depthGradient; // change of stored depth per unit of atlas UV along the receiver's plane; 0 if unknown
    float2 rotation;      // (cos, sin) of this pixel's disk rotation, unit length
};

struct ShadowTile
{
    float4 offsetScale;    // xy: the tile's origin, zw: its extent, in atlas UV
    float4 atlasTexelSize; // 1/width, 1/height, width, height of the atlas
    float uvPerMetre;      // tile UV per metre across the light
    float depthPerMetre;   // stored depth per metre along the light
    float depthToRadial;   // penumbra radius in tile UV per unit of stored depth: tan(a/2) uvPerMetre / depthPerMetre
    float radialToDepth;   // its inverse, 0 at angular diameter 0
};

#endif
