// Penumbra: soft shadows of URP's additional spot lights, in one include.
//
//   #pragma multi_compile_fragment _ _ADDITIONAL_LIGHT_SHADOWS
//   #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
//   #include "Packages/com.penumbra.shadows/ShaderLibrary/SpotShadows.hlsl"
//   ...
//   LIGHT_LOOP_BEGIN(GetAdditionalLightsCount())
//       Light light = GetAdditionalLight(lightIndex, positionWS);
//       int index = GetPerObjectLightIndex(lightIndex);  // in Forward+: lightIndex itself
//       light.shadowAttenuation = PenumbraAdditionalLightVisibility(index, positionWS, normalWS, positionCS.xy, 0.05);
//
// Computes:   visibility of one spot light, a disc of the given radius, at a world position, with FilterPcssSpot. Where
//             raw depths cannot be read (OpenGL, WebGL), tent 5 x 5.
// Source:     Filters/Pcss/PcssSpot.hlsl.
// Inputs:     lightIndex: of URP's visible lights; positionWS, metres; normalWS: the geometric normal, unit; pixel:
//             screen coordinate; sourceRadiusMetres: of the lamp's disc, which URP's lights do not have. The uniform
//             _PenumbraPcssSpotParameters0, which the C# struct PcssSpotParameters sets.
// Cost:       the filter's fetches; none outside of the light's map.
// Guarantees: [0, 1]; 1 where no map covers the position, for lights of other types and for those without a shadow, so
//             that point lights keep URP's shadows if the caller multiplies by the smaller of both. URP's shadow
//             strength is applied, its distance fade is not. Without the keyword _ADDITIONAL_LIGHT_SHADOWS, 1 and no
//             fetch.
// Use it:     in forward shaders. Not: for the main light (Shadows.hlsl).
#ifndef PENUMBRA_SPOT_SHADOWS_HLSL
#define PENUMBRA_SPOT_SHADOWS_HLSL

#include "Pipelines/Urp.hlsl"

#if defined(ADDITIONAL_LIGHT_CALCULATE_SHADOWS)

#include "Pipelines/UrpSpotLights.hlsl"
#include "Filters/Pcss/PcssSpot.hlsl"

// This condition is that of Pipelines/TechniqueByKeyword.hlsl.
#if !defined(PENUMBRA_RAW_DEPTH_READS) && \
    (defined(SHADER_API_GLCORE) || defined(SHADER_API_GLES) || defined(SHADER_API_GLES3) || \
     defined(SHADER_API_WEBGL) || defined(SHADER_API_WEBGPU))
#define PENUMBRA_SPOT_WITHOUT_GATHER
#include "Filters/Fixed/TentPcf.hlsl"
#endif

float4 _PenumbraPcssSpotParameters0;

float PenumbraAdditionalLightVisibility(int lightIndex, float3 positionWS, float3 normalWS, float2 pixel,
                                        float sourceRadiusMetres)
{
    const PenumbraSpotLight shadow =
        PreparePenumbraSpotLight(lightIndex, positionWS, normalWS, pixel, sourceRadiusMetres);
    if (!shadow.covered) return 1.0;
#if defined(PENUMBRA_SPOT_WITHOUT_GATHER)
    const float visibility =
        FilterTent5x5Plane(TEXTURE2D_SHADOW_ARGS(_AdditionalLightsShadowmapTexture, sampler_PenumbraLinearClampCompare),
                           shadow.receiver, shadow.tile);
#else
    const float visibility =
        FilterPcssSpot(TEXTURE2D_SHADOW_ARGS(_AdditionalLightsShadowmapTexture, sampler_PenumbraLinearClampCompare),
                       sampler_PenumbraPointClamp, shadow.map, shadow.receiver, shadow.tile,
                       UnpackPcssSpotParameters(_PenumbraPcssSpotParameters0));
#endif
    return 1.0 + shadow.strength * (visibility - 1.0);
}

#else

float PenumbraAdditionalLightVisibility(int lightIndex, float3 positionWS, float3 normalWS, float2 pixel,
                                        float sourceRadiusMetres)
{
    return 1.0;
}

#endif
#endif
