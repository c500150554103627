// Custom pipeline sample: depth as seen from the sun, biased as the library's receivers expect.
#ifndef PENUMBRA_SAMPLE_SUN_CASTER_PASS_HLSL
#define PENUMBRA_SAMPLE_SUN_CASTER_PASS_HLSL

#include "PipelineInput.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Core/ShadowBias.hlsl"

struct Attributes
{
    float3 positionOS : POSITION;
    float3 normalOS : NORMAL;
};

// Casters between the sun and the cascade's near plane are moved onto the plane instead of being clipped.
float4 KeepOnNearPlane(float4 positionCS)
{
#if UNITY_REVERSED_Z
    positionCS.z = min(positionCS.z, positionCS.w);
#else
    positionCS.z = max(positionCS.z, -positionCS.w);
#endif
    return positionCS;
}

float4 SunCasterVertex(Attributes input) : SV_POSITION
{
    const float3 positionWS = ObjectToWorld(input.positionOS);
    const float3 normalWS = NormalToWorld(input.normalOS);
    return KeepOnNearPlane(WorldToClip(BiasCaster(positionWS, normalWS, _SunDirection.xyz, _SunCasterBias.xy)));
}

float4 SunCasterFragment() : SV_Target
{
    return 0.0;
}

#endif
