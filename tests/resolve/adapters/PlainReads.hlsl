// Reads without macros, one of them in a branch.
Texture2D _ShadowMap;
SamplerComparisonState sampler_ShadowMap;
SamplerState sampler_PointClamp;
float4x4 _PenumbraWorldToShadow[5];
float PeekAtMap(float3 at) { return _ShadowMap.SampleCmpLevelZero(sampler_ShadowMap, at.xy, at.z); }
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    const float3 at = mul(_PenumbraWorldToShadow[0], float4(positionWS, 1.0)).xyz;
    float visibility = PeekAtMap(at);
    if (visibility > 0.5) visibility += 0.0 * _ShadowMap.GatherRed(sampler_PointClamp, at.xy).x;
    return visibility;
}
