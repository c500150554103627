// Stands in for the core package's SpaceTransforms.hlsl, with the matrices that URP's Input.hlsl brings before it: from
// object space to clip space. Names and signatures are Unity's interface (core and URP 14 to 17).
#ifndef UNITY_SPACE_TRANSFORMS_INCLUDED
#define UNITY_SPACE_TRANSFORMS_INCLUDED

CBUFFER_START(UnityPerDraw)
float4x4 unity_ObjectToWorld;
float4x4 unity_WorldToObject;
float4 unity_LODFade;
float4 unity_WorldTransformParams;
CBUFFER_END

float4x4 unity_MatrixVP;

float3 TransformObjectToWorld(float3 positionOS)
{
    return mul(unity_ObjectToWorld, float4(positionOS, 1.0)).xyz;
}

float4 TransformWorldToHClip(float3 positionWS)
{
    return mul(unity_MatrixVP, float4(positionWS, 1.0));
}

float4 TransformObjectToHClip(float3 positionOS)
{
    return TransformWorldToHClip(TransformObjectToWorld(positionOS));
}

float3 TransformObjectToWorldNormal(float3 normalOS)
{
    return normalize(mul(normalOS, (float3x3)unity_WorldToObject));
}

#endif
