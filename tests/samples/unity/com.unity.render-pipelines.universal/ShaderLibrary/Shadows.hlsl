// Stands in for what the forward shader sample uses of URP's Shadows.hlsl.
#ifndef PENUMBRA_SAMPLES_SHADOWS_INCLUDED
#define PENUMBRA_SAMPLES_SHADOWS_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "../../../../../tools/programs/shaders/unity/com.unity.render-pipelines.universal/ShaderLibrary/UrpGlobals.hlsl"

#if defined(_MAIN_LIGHT_SHADOWS) || defined(_MAIN_LIGHT_SHADOWS_CASCADE) || defined(_MAIN_LIGHT_SHADOWS_SCREEN)
#define MAIN_LIGHT_CALCULATE_SHADOWS
#endif

half GetMainLightShadowFade(float3 positionWS)
{
    return half(saturate(length(positionWS) * _MainLightShadowParams.z + _MainLightShadowParams.w));
}

#if defined(ADDITIONAL_LIGHT_CALCULATE_SHADOWS)
half GetAdditionalLightShadowFade(float3 positionWS)
{
    return half(saturate(length(positionWS) * 0.01));
}
#endif

float3 ApplyShadowBias(float3 positionWS, float3 normalWS, float3 lightDirection)
{
    return positionWS + lightDirection * _ShadowBias.x + normalWS * _ShadowBias.y;
}

#endif
