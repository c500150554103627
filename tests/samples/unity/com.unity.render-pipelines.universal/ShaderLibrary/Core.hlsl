// Stands in for what the forward shader sample uses of URP's Core.hlsl, and of the core package through it: names and
// signatures are Unity's interface (core and URP 14 to 17), bodies are the plainest that give a picture.
#ifndef PENUMBRA_SAMPLES_CORE_INCLUDED
#define PENUMBRA_SAMPLES_CORE_INCLUDED

#include "../../../../../tools/programs/shaders/unity/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "../../../../../tools/programs/shaders/unity/com.unity.render-pipelines.core/ShaderLibrary/SpaceTransforms.hlsl"

// URP 14 and 17.0 have it so.
#if defined(_FORWARD_PLUS)
#define USE_FORWARD_PLUS 1
#else
#define USE_FORWARD_PLUS 0
#endif

#if defined(UNITY_REVERSED_Z)
#define UNITY_NEAR_CLIP_VALUE 1.0
#else
#define UNITY_NEAR_CLIP_VALUE -1.0
#endif

#define UNITY_TRANSFER_INSTANCE_ID(input, output)
#define SAMPLE_TEXTURE2D(textureName, samplerName, uv) textureName.Sample(samplerName, uv)
#define TRANSFORM_TEX(uv, name) ((uv) * name##_ST.xy + name##_ST.zw)
#define MAX_VISIBLE_LIGHTS 256

float4 _ScaledScreenParams;
half4 unity_FogColor;

half3 NormalizeNormalPerPixel(half3 normalWS)
{
    return normalize(normalWS);
}

half3 GetWorldSpaceNormalizeViewDir(float3 positionWS)
{
    return half3(normalize(_WorldSpaceCameraPos - positionWS));
}

float2 GetNormalizedScreenSpaceUV(float4 positionCS)
{
    return positionCS.xy / _ScaledScreenParams.xy;
}

half ComputeFogFactor(float depth)
{
    return half(depth);
}

half3 MixFog(half3 colour, half factor)
{
    return lerp(unity_FogColor.rgb, colour, factor);
}

float2 PackNormalOctQuadEncode(float3 normal)
{
    return normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
}

half3 PackFloat2To888(half2 values)
{
    return half3(values, 0.0);
}

#endif
