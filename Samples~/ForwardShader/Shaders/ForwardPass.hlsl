// Forward shader sample: URP's physically based lighting, with the shadows of the main light and of spot lights from
// the Penumbra library.
//
// Computes:   the colour of an opaque surface: main light times PenumbraMainLightVisibility, URP's additional spot
//             lights times PenumbraAdditionalLightVisibility, point lights without shadows, ambient light from probes,
//             fog.
// Inputs:     URP's uniforms; those of Shadows.hlsl, from the renderer feature or from ForwardShadowUniforms.cs; that
//             of SpotShadows.hlsl, from the latter.
// Cost:       the material's technique in every pixel that faces the light, and PCSS for each spot light with a shadow
//             that lights it. Unlike with the renderer feature, the
//             work of overdrawn pixels is lost, and there is no mask and no denoising.
// Guarantees: where URP has no shadow map for the main light (its keywords are off), the light is unshadowed and no
//             texture is read.
#ifndef PENUMBRA_SAMPLE_FORWARD_PASS_HLSL
#define PENUMBRA_SAMPLE_FORWARD_PASS_HLSL

#include "SurfaceInput.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Shadows.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/SpotShadows.hlsl"

// These are the macros that URP sets for its Forward+ keyword: the first until 17.0, the second from 17.1 on.
#if (defined(USE_FORWARD_PLUS) && USE_FORWARD_PLUS) || (defined(USE_CLUSTER_LIGHT_LOOP) && USE_CLUSTER_LIGHT_LOOP)
#define SAMPLE_USES_CLUSTERS 1
#else
#define SAMPLE_USES_CLUSTERS 0
#endif

struct Attributes
{
    float4 positionOS : POSITION;
    float3 normalOS : NORMAL;
    float2 uv : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 positionCS : SV_POSITION;
    float3 positionWS : TEXCOORD0;
    half3 normalWS : TEXCOORD1;
    float2 uv : TEXCOORD2;
    half fogFactor : TEXCOORD3;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

Varyings ForwardVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_TRANSFER_INSTANCE_ID(input, output);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output);
    output.positionWS = TransformObjectToWorld(input.positionOS.xyz);
    output.positionCS = TransformWorldToHClip(output.positionWS);
    output.normalWS = half3(TransformObjectToWorldNormal(input.normalOS));
    output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
    output.fogFactor = half(ComputeFogFactor(output.positionCS.z));
    return output;
}

// The distance fade is not applied here, because URP leaves it to the library's caller.
half MainLightVisibility(float3 positionWS, half3 normalWS, float2 pixel)
{
#if defined(MAIN_LIGHT_CALCULATE_SHADOWS)
    const float visibility = PenumbraMainLightVisibility(positionWS, normalWS, pixel);
    return half(lerp(visibility, 1.0, GetMainLightShadowFade(positionWS)));
#else
    return half(1.0);
#endif
}

// index is what GetAdditionalLight takes. With clusters it is the light's own; otherwise an object's list says which
// light it is.
half SpotLightVisibility(uint index, InputData inputData, float2 pixel)
{
#if defined(ADDITIONAL_LIGHT_CALCULATE_SHADOWS)
#if SAMPLE_USES_CLUSTERS
    const int light = int(index);
#else
    const int light = GetPerObjectLightIndex(index);
#endif
    const float visibility =
        PenumbraAdditionalLightVisibility(light, inputData.positionWS, inputData.normalWS, pixel, _LampRadius);
    return half(lerp(visibility, 1.0, GetAdditionalLightShadowFade(inputData.positionWS)));
#else
    return half(1.0);
#endif
}

// URP's LIGHT_LOOP macros read a variable of the name inputData.
half3 AdditionalLights(InputData inputData, BRDFData brdf, float2 pixel)
{
    half3 colour = half3(0.0, 0.0, 0.0);
#if defined(_ADDITIONAL_LIGHTS) || SAMPLE_USES_CLUSTERS
    // InputData has the normal as float3, and half has 16 bits on some devices.
    const half3 normalWS = half3(inputData.normalWS);
#if SAMPLE_USES_CLUSTERS
    // Directional lights are in no cluster.
    UNITY_LOOP
    for (uint i = 0u; i < min(uint(URP_FP_DIRECTIONAL_LIGHTS_COUNT), uint(MAX_VISIBLE_LIGHTS)); ++i)
    {
        const Light light = GetAdditionalLight(i, inputData.positionWS);
        colour += LightingPhysicallyBased(brdf, light, normalWS, inputData.viewDirectionWS);
    }
#endif
    const uint lightCount = GetAdditionalLightsCount();
    LIGHT_LOOP_BEGIN(lightCount)
        Light light = GetAdditionalLight(lightIndex, inputData.positionWS);
        UNITY_BRANCH
        if (light.distanceAttenuation > 0.0 && dot(normalWS, light.direction) > 0.0)
        {
            light.shadowAttenuation = SpotLightVisibility(lightIndex, inputData, pixel);
        }
        colour += LightingPhysicallyBased(brdf, light, normalWS, inputData.viewDirectionWS);
    LIGHT_LOOP_END
#endif
    return colour;
}

InputData LightingInput(Varyings input)
{
    InputData inputData = (InputData)0;
    inputData.positionWS = input.positionWS;
    inputData.normalWS = NormalizeNormalPerPixel(input.normalWS);
    inputData.viewDirectionWS = GetWorldSpaceNormalizeViewDir(input.positionWS);
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(input.positionCS);
    return inputData;
}

half4 ForwardFragment(Varyings input) : SV_Target
{
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const half3 albedo = half3((SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv) * _BaseColor).rgb);
    half alpha = half(1.0);
    BRDFData brdf;
    InitializeBRDFData(albedo, _Metallic, half3(0.0, 0.0, 0.0), _Smoothness, alpha, brdf);

    const InputData inputData = LightingInput(input);
    const half3 normalWS = half3(inputData.normalWS);
    const half3 viewWS = inputData.viewDirectionWS;
    half3 colour = GlobalIllumination(brdf, SampleSH(normalWS), half(1.0), inputData.positionWS, normalWS, viewWS);

    Light sun = GetMainLight();
    // Surfaces that face away from the light need no fetches.
    UNITY_BRANCH
    if (dot(normalWS, sun.direction) > 0.0)
    {
        sun.shadowAttenuation = MainLightVisibility(inputData.positionWS, normalWS, input.positionCS.xy);
        colour += LightingPhysicallyBased(brdf, sun, normalWS, viewWS);
    }
    colour += AdditionalLights(inputData, brdf, input.positionCS.xy);
    return half4(MixFog(colour, input.fogFactor), 1.0);
}

#endif
