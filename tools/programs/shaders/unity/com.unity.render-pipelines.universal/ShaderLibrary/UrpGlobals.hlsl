// The globals of Unity's URP that Pipelines/Urp.hlsl and UrpSpotLights.hlsl read, declared so that the library's URP
// side compiles and runs without Unity. Names, types and array lengths are URP's interface (14 to 17); include it after
// the platform macros.
#ifndef UNIVERSAL_SHADOWS_INCLUDED
#define UNIVERSAL_SHADOWS_INCLUDED

float4x4 _MainLightWorldToShadow[5];
float4 _CascadeShadowSplitSpheres0;
float4 _CascadeShadowSplitSpheres1;
float4 _CascadeShadowSplitSpheres2;
float4 _CascadeShadowSplitSpheres3;
float4 _CascadeShadowSplitSphereRadii; // squared
float4 _MainLightShadowParams;         // x: strength
float4 _ShadowBias;                    // x: depth, y: normal bias

TEXTURE2D_SHADOW(_MainLightShadowmapTexture);
TEXTURE2D_X(_ScreenSpaceShadowmapTexture);

#if defined(_ADDITIONAL_LIGHT_SHADOWS)
#define ADDITIONAL_LIGHT_CALCULATE_SHADOWS
#ifndef USE_STRUCTURED_BUFFER_FOR_LIGHT_DATA
#define USE_STRUCTURED_BUFFER_FOR_LIGHT_DATA 0
#endif
TEXTURE2D_SHADOW(_AdditionalLightsShadowmapTexture);
#if USE_STRUCTURED_BUFFER_FOR_LIGHT_DATA
struct LightData // of these, what is read here
{
    float4 position;
    half4 attenuation;
};
StructuredBuffer<LightData> _AdditionalLightsBuffer;
StructuredBuffer<float4> _AdditionalShadowParams_SSBO;
StructuredBuffer<float4x4> _AdditionalLightsWorldToShadow_SSBO;
#else
half4 _AdditionalLightsAttenuation[256];
half4 _AdditionalShadowParams[256];
float4x4 _AdditionalLightsWorldToShadow[545];
#endif

half4 GetAdditionalLightShadowParams(int lightIndex)
{
#if USE_STRUCTURED_BUFFER_FOR_LIGHT_DATA
    return half4(_AdditionalShadowParams_SSBO[lightIndex]);
#else
    return _AdditionalShadowParams[lightIndex];
#endif
}
#endif

#endif
