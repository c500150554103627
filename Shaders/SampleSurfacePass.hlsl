// Penumbra: what each sample of a multisampled camera picture sees.
//
// Computes:   the casters as the camera sees them: depth, and the normal of each triangle.
// Source:     the triangle's normal is the cross product of how its world position changes over the screen.
// Inputs:     vertices as URP's own passes have them; _BaseMap, _BaseColor and _Cutoff with _ALPHATEST_ON.
// Cost:       a draw of the scene; 1 fetch with alpha test.
// Guarantees: the fragment program runs once for a triangle and pixel, so that all samples that a triangle covers in a
//             pixel hold the same normal. It has either sign; its length is 1.
// Use it:     into a multisampled rgba16f target with depth. Not: where the pipeline has multisampled normals.
#ifndef PENUMBRA_SAMPLE_SURFACE_PASS_HLSL
#define PENUMBRA_SAMPLE_SURFACE_PASS_HLSL

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SpaceTransforms.hlsl"
#include "CasterMaterial.hlsl"

struct SurfaceAttributes
{
    float4 positionOS : POSITION;
    float2 uv : TEXCOORD0;
};

struct SurfaceVaryings
{
    float4 positionCS : SV_POSITION;
    float3 positionWS : TEXCOORD0;
#if defined(_ALPHATEST_ON)
    float2 uv : TEXCOORD1;
#endif
};

SurfaceVaryings SurfaceVertex(SurfaceAttributes input)
{
    SurfaceVaryings output;
    output.positionWS = TransformObjectToWorld(input.positionOS.xyz);
    output.positionCS = TransformWorldToHClip(output.positionWS);
#if defined(_ALPHATEST_ON)
    output.uv = MaterialCoordinates(input.uv);
#endif
    return output;
}

float4 SampleSurface(SurfaceVaryings input) : SV_Target
{
    const float3 normal = cross(ddx(input.positionWS), ddy(input.positionWS));
#if defined(_ALPHATEST_ON)
    clip(MaterialAlpha(input.uv) - _Cutoff);
#endif
    return float4(normalize(normal), 0.0);
}

#endif
