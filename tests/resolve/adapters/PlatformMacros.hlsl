// The library's own macros of the platform.
#include "Platform/Platform.hlsl"
TEXTURE2D_SHADOW(_ShadowMap);
SAMPLER_CMP(sampler_ShadowMap);
float4x4 _PenumbraWorldToShadow[5];
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    const float3 at = mul(_PenumbraWorldToShadow[0], float4(positionWS, 1.0)).xyz;
    return SAMPLE_TEXTURE2D_SHADOW(_ShadowMap, sampler_ShadowMap, at);
}
