// Custom pipeline sample: diffuse light of the sun times its visibility, and uniform ambient light.
#ifndef PENUMBRA_SAMPLE_SUN_LIT_PASS_HLSL
#define PENUMBRA_SAMPLE_SUN_LIT_PASS_HLSL

#include "PipelineInput.hlsl"
#include "SunShadow.hlsl"

struct Attributes
{
    float3 positionOS : POSITION;
    float3 normalOS : NORMAL;
};

struct Varyings
{
    float4 positionCS : SV_POSITION;
    float3 positionWS : TEXCOORD0;
    float3 normalWS : TEXCOORD1;
};

Varyings SunLitVertex(Attributes input)
{
    Varyings output;
    output.positionWS = ObjectToWorld(input.positionOS);
    output.normalWS = NormalToWorld(input.normalOS);
    output.positionCS = WorldToClip(output.positionWS);
    return output;
}

float4 SunLitFragment(Varyings input) : SV_Target
{
    const float3 normalWS = normalize(input.normalWS);
    const float cosine = max(dot(normalWS, _SunDirection.xyz), 0.0);
    float3 light = _Ambient.rgb;
    // Surfaces that face away from the sun need no fetches.
    UNITY_BRANCH
    if (cosine > 0.0)
    {
        light += _SunColor.rgb * cosine * SunVisibility(input.positionWS, normalWS, input.positionCS.xy);
    }
    return float4(_BaseColor.rgb * light, 1.0);
}

#endif
