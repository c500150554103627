// URP's own main light shadow, for comparison: penumbra measure
//   --package-root com.unity.render-pipelines.core=DIR --package-root com.unity.render-pipelines.universal=DIR
//   --adapter "urp-medium=tools/measurement/resolve/adapters/UrpSoftShadows.hlsl;_SHADOWS_SOFT;_SHADOWS_SOFT_MEDIUM"
//
// Computes:   MainLightRealtimeShadow of the URP whose package root is given: cascade selection, the comparison
//             taps and the strength, nothing of ours; saturated, because URP's 5x5 weights add up to a little more
//             than 1 in places, and visibility over 1 counts as invalid here.
// Inputs:     URP's keywords choose the quality: none (hard), _SHADOWS_SOFT with _SHADOWS_SOFT_LOW (4 taps),
//             _SHADOWS_SOFT_MEDIUM (tent 5x5) or _SHADOWS_SOFT_HIGH (tent 7x7). URP before 14 knows _SHADOWS_SOFT
//             only, which is its tent 5x5. URP 14 and later also include com.unity.render-pipelines.universal-config:
//             give its root too.
// Cost:       URP's: 1, 4, 9 or 16 fetches.
#define _MAIN_LIGHT_SHADOWS_CASCADE 1

// What Unity's compiler says about the platform. URP ties the depth direction to it.
#if UNITY_REVERSED_Z
#define SHADER_API_D3D11 1
#else
#define SHADER_API_GLCORE 1
#endif

// As URP's own passes include it: Shadows.hlsl calls what CommonMaterial.hlsl defines.
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"

float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    return saturate(MainLightRealtimeShadow(TransformWorldToShadowCoord(positionWS)));
}
