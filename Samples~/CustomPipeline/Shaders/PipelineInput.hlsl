// Custom pipeline sample: the uniforms that the engine sets, under the engine's names, and those of the pipeline.
//
// Computes:   positions in world and clip space, and normals in world space, from object space.
// Inputs:     UnityPerDraw in the engine's order, which the SRP Batcher requires; unity_MatrixVP from
//             SetupCameraProperties, and from SetViewProjectionMatrices while the shadow map is drawn; _Sun* from
//             SoftShadowPipeline.cs.
// Guarantees: nothing of another pipeline is included: UNITY_REVERSED_Z, which Unity's own headers define, is
//             defined here, and must be before the first file of the library.
#ifndef PENUMBRA_SAMPLE_PIPELINE_INPUT_HLSL
#define PENUMBRA_SAMPLE_PIPELINE_INPUT_HLSL

// OpenGL keeps depth from near to far; every other API of Unity reverses it (SystemInfo.usesReversedZBuffer).
#if !defined(SHADER_API_GLCORE) && !defined(SHADER_API_GLES3) && !defined(SHADER_API_GLES)
#define UNITY_REVERSED_Z 1
#endif

#include "Packages/com.penumbra.shadows/ShaderLibrary/Platform/Platform.hlsl"

CBUFFER_START(UnityPerDraw)
float4x4 unity_ObjectToWorld;
float4x4 unity_WorldToObject;
float4 unity_LODFade;
float4 unity_WorldTransformParams;
CBUFFER_END

CBUFFER_START(UnityPerMaterial)
float4 _BaseColor;
CBUFFER_END

float4x4 unity_MatrixVP;

float4 _SunDirection;  // xyz: unit, world space, from a surface to the sun
float4 _SunColor;      // rgb: linear
float4 _Ambient;       // rgb: linear, equal from all directions
float4 _SunCasterBias; // xy: metres along the light and against the normal, both <= 0, for the cascade being drawn

float3 ObjectToWorld(float3 positionOS)
{
    return mul(unity_ObjectToWorld, float4(positionOS, 1.0)).xyz;
}

float3 NormalToWorld(float3 normalOS)
{
    return normalize(mul(normalOS, (float3x3)unity_WorldToObject));
}

float4 WorldToClip(float3 positionWS)
{
    return mul(unity_MatrixVP, float4(positionWS, 1.0));
}

#endif
