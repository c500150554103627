// The mean of nine comparisons, one texel apart.
#include "Packages/test.core/ShaderLibrary/Common.hlsl"
TEXTURE2D_SHADOW(_MainLightShadowmapTexture);
SAMPLER_CMP(sampler_LinearClampCompare);
float4x4 _MainLightWorldToShadow[5];
float4 _MainLightShadowmapSize;
float4 _NobodyProvidesThis;
float4 _NobodyReadsThis;
half Row(TEXTURE2D_SHADOW_PARAM(map, sampler_map), float3 at, half y)
{
    const float2 texel = _MainLightShadowmapSize.xy;
    return Mean3(SAMPLE_TEXTURE2D_SHADOW(map, sampler_map, at + float3(float2(-1.0, y) * texel, 0.0)),
                 SAMPLE_TEXTURE2D_SHADOW(map, sampler_map, at + float3(float2(0.0, y) * texel, 0.0)),
                 SAMPLE_TEXTURE2D_SHADOW(map, sampler_map, at + float3(float2(1.0, y) * texel, 0.0)));
}
float MeanOfNine(float3 positionWS)
{
    const float3 at = mul(_MainLightWorldToShadow[0], float4(positionWS, 1.0)).xyz;
    return Mean3(Row(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_LinearClampCompare), at, -1.0),
                 Row(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_LinearClampCompare), at, 0.0),
                 Row(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_LinearClampCompare), at, 1.0)) +
           _NobodyProvidesThis.x;
}
