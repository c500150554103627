// Stands in for what the forward shader sample uses of URP's Lighting.hlsl.
#ifndef PENUMBRA_SAMPLES_LIGHTING_INCLUDED
#define PENUMBRA_SAMPLES_LIGHTING_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"

struct Light
{
    half3 direction;
    half3 color;
    float distanceAttenuation;
    half shadowAttenuation;
    uint layerMask;
};

struct BRDFData
{
    half3 diffuse;
    half3 specular;
};

struct InputData
{
    float3 positionWS;
    half3 normalWS;
    half3 viewDirectionWS;
    float2 normalizedScreenSpaceUV;
};

half4 _MainLightColor;
half4 _AdditionalLightsCount;
float4 _FPParams0;

#if USE_FORWARD_PLUS
// URP declares two of these; only a loop over clusters needs them.
#define URP_FP_DIRECTIONAL_LIGHTS_COUNT ((uint)_FPParams0.w)
#define LIGHT_LOOP_BEGIN(lightCount) { uint lightIndex = (uint)inputData.normalizedScreenSpaceUV.x; {
#define LIGHT_LOOP_END } }
#else
#define LIGHT_LOOP_BEGIN(lightCount) for (uint lightIndex = 0u; lightIndex < lightCount; ++lightIndex) {
#define LIGHT_LOOP_END }
#endif

Light GetMainLight()
{
    Light light;
    light.direction = half3(_MainLightPosition.xyz);
    light.color = _MainLightColor.rgb;
    light.distanceAttenuation = 1.0;
    light.shadowAttenuation = half(1.0);
    light.layerMask = 0u;
    return light;
}

uint GetAdditionalLightsCount()
{
    return uint(_AdditionalLightsCount.x);
}

int GetPerObjectLightIndex(uint index)
{
    return int(index);
}

Light GetAdditionalLight(uint i, float3 positionWS)
{
    Light light = GetMainLight();
    light.direction = half3(normalize(positionWS + float(i)));
    return light;
}

void InitializeBRDFData(half3 albedo, half metallic, half3 specular, half smoothness, inout half alpha,
                        out BRDFData brdf)
{
    brdf.diffuse = albedo * (half(1.0) - metallic) * alpha;
    brdf.specular = lerp(specular, albedo, metallic) * smoothness;
}

half3 SampleSH(half3 normalWS)
{
    return normalWS * half(0.5) + half(0.5);
}

half3 GlobalIllumination(BRDFData brdf, half3 bakedGI, half occlusion, float3 positionWS, half3 normalWS,
                         half3 viewDirectionWS)
{
    return brdf.diffuse * bakedGI * occlusion + brdf.specular * saturate(dot(normalWS, viewDirectionWS));
}

half3 LightingPhysicallyBased(BRDFData brdf, Light light, half3 normalWS, half3 viewDirectionWS)
{
    const half cosine = saturate(dot(normalWS, light.direction));
    const half attenuation = half(light.distanceAttenuation) * light.shadowAttenuation;
    return (brdf.diffuse + brdf.specular * saturate(dot(viewDirectionWS,
                                                        normalWS))) * light.color * cosine * attenuation;
}

#endif
