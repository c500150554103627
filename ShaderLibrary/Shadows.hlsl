// Penumbra: soft shadows of URP's main light, in one include.
//
//   #pragma multi_compile_fragment _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN
//   #pragma multi_compile_local_fragment _ _PENUMBRA_TENT_3X3 _PENUMBRA_TENT_7X7 _PENUMBRA_PCSS
//   #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
//   #include "Packages/com.penumbra.shadows/ShaderLibrary/Shadows.hlsl"
//   ...
//   float visibility = 1.0;
//   #if defined(MAIN_LIGHT_CALCULATE_SHADOWS)  // URP's, from its keywords: without one on, it has no shadow map
//   visibility = PenumbraMainLightVisibility(positionWS, normalWS, positionCS.xy);
//   #endif
//
// Computes:   visibility of the main light at a world position, with the technique that the keyword selects:
//             _PENUMBRA_HARD, _PENUMBRA_BILINEAR, _PENUMBRA_FOUR_TAP, _PENUMBRA_TENT_3X3, _PENUMBRA_TENT_7X7,
//             _PENUMBRA_PCSS, _PENUMBRA_PCSS_BOUNDED (the filter of Tiled PCSS), _PENUMBRA_PCSS_POISSON,
//             _PENUMBRA_PCSS_HDRP, _PENUMBRA_SINGLE_LOOP, _PENUMBRA_SMRT, _PENUMBRA_PCSS_GODOT,
//             _PENUMBRA_DPCF_FILAMENT, _PENUMBRA_PCSS_FILAMENT; without a keyword, tent 5 x 5.
//             Pipelines/TechniqueByKeyword.hlsl has those of filters that read maps, for the renderer feature's passes.
//             With PENUMBRA_MAPS_BOUND, your shader may have the filter of the feature's own technique.
// Source:     see each filter's file.
// Inputs:     positionWS, metres; normalWS: the geometric normal, unit; pixel: screen coordinate. The uniforms of
//             Pipelines/Urp.hlsl and, of PCSS, of Pipelines/TechniqueByKeyword.hlsl.
// Cost:       the technique's fetches; none outside of the shadow map.
// Guarantees: [0, 1]; 1 beyond the shadow distance. URP's shadow strength is applied, its distance fade is not.
// Use it:     in forward shaders, and in screen passes. Not: for additional lights, whose shadows remain URP's.
#ifndef PENUMBRA_SHADOWS_HLSL
#define PENUMBRA_SHADOWS_HLSL

#include "Pipelines/Urp.hlsl"
#include "Pipelines/TechniqueByKeyword.hlsl"

float PenumbraMainLightVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    const PenumbraMainLight shadow = PreparePenumbraMainLight(positionWS, normalWS, pixel);
    if (!shadow.covered) return 1.0;
    const float visibility =
        FilterByKeyword(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_PenumbraLinearClampCompare),
                        sampler_PenumbraPointClamp, shadow.receiver, shadow.tile, shadow.cascade);
    return ApplyPenumbraStrength(visibility);
}

#endif
