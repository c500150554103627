// URP's own main light shadow, for comparison: penumbra measure
//   --package-root com.unity.render-pipelines.core=DIR --package-root com.unity.render-pipelines.universal=DIR
//   --adapter "urp-medium=tools/resolve/adapters/UrpSoftShadows.hlsl;_SHADOWS_SOFT;_SHADOWS_SOFT_MEDIUM"
//
// Computes:   MainLightRealtimeShadow of the URP whose package root is given: cascade selection, the comparison
//             taps and the strength, nothing of ours.
// Inputs:     URP's keywords choose the quality: none (hard), _SHADOWS_SOFT with _SHADOWS_SOFT_LOW (4 taps),
//             _SHADOWS_SOFT_MEDIUM (tent 5x5) or _SHADOWS_SOFT_HIGH (tent 7x7). URP before 14 knows _SHADOWS_SOFT only.
// Cost:       URP's: 1, 4, 9 or 16 fetches.
#define _MAIN_LIGHT_SHADOWS_CASCADE 1
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"

float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    return MainLightRealtimeShadow(TransformWorldToShadowCoord(positionWS));
}
