// Penumbra: a caster's material.
//
// Computes:   the alpha of its base map and colour.
// Source:     URP's Lit and particle shaders name them so.
// Inputs:     _BaseMap, _BaseMap_ST, _BaseColor, and of materials with alpha test _Cutoff: the material's own, as
//             casters are drawn with another shader and keep their properties.
// Cost:       1 fetch.
// Guarantees: -
// Use it:     in passes that draw casters, in the fragment program: the base map has mip levels.
#ifndef PENUMBRA_CASTER_MATERIAL_HLSL
#define PENUMBRA_CASTER_MATERIAL_HLSL

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

TEXTURE2D(_BaseMap);
SAMPLER(sampler_BaseMap);
float4 _BaseMap_ST;
float4 _BaseColor;
float _Cutoff;

float2 MaterialCoordinates(float2 uv)
{
    return uv * _BaseMap_ST.xy + _BaseMap_ST.zw;
}

float MaterialAlpha(float2 uv)
{
    return _BaseColor.a * SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, uv).a;
}

#endif
