// Penumbra: soft shadows of URP's main light, in one include.
//
//   #pragma multi_compile_local _ _PENUMBRA_TENT_3X3 _PENUMBRA_TENT_7X7 _PENUMBRA_PCSS
//   #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
//   #include "Packages/com.penumbra.shadows/ShaderLibrary/Shadows.hlsl"
//   ...
//   float visibility = PenumbraMainLightVisibility(positionWS, normalWS, positionCS.xy);
//
// Computes:   visibility of the main light at a world position by the technique the keyword names:
//             _PENUMBRA_HARD, _PENUMBRA_BILINEAR, _PENUMBRA_FOUR_TAP, _PENUMBRA_TENT_3X3, _PENUMBRA_TENT_7X7,
//             _PENUMBRA_PCSS, _PENUMBRA_PCSS_POISSON, _PENUMBRA_PCSS_HDRP; without one, tent 5 x 5.
// Source:     each filter's file names its own.
// Inputs:     positionWS, metres; normalWS: the geometric normal, unit; pixel: screen coordinate. Uniforms
//             _PenumbraSamples: blocker samples, filter samples, search clump, smallest filter radius (texels);
//             _PenumbraLimits: widest penumbra (m), cone height (m), search radius of classic PCSS (m); HDRP's tangents
//             in _PenumbraHdrp.xy.
// Cost:       the technique's fetches; none where no shadow map reaches.
// Guarantees: [0, 1]; 1 beyond the shadow distance. URP's shadow strength is applied, its distance fade is not.
// Use it:     in forward shaders, and in screen passes. Not: as URP's additional-light shadows, which stay URP's.
#ifndef PENUMBRA_SHADOWS_HLSL
#define PENUMBRA_SHADOWS_HLSL

#include "Pipelines/Urp.hlsl"
#include "Core/TechniqueParameters.hlsl"

// PCSS reads depths by gather. Where there is none, or where a raw read of a comparison texture is undefined (OpenGL
// ES before 3.1, WebGL), the widest tent stands in.
#if defined(SHADER_API_GLES) || defined(SHADER_API_WEBGL) || (defined(SHADER_API_GLES3) && (SHADER_TARGET < 45))
#define PENUMBRA_WITHOUT_GATHER
#endif

#if defined(_PENUMBRA_PCSS) || defined(_PENUMBRA_PCSS_POISSON) || defined(_PENUMBRA_PCSS_HDRP)
#if defined(PENUMBRA_WITHOUT_GATHER)
#define PENUMBRA_USES_TENT_7X7
#else
#define PENUMBRA_USES_PCSS
#endif
#elif defined(_PENUMBRA_TENT_7X7)
#define PENUMBRA_USES_TENT_7X7
#endif

#if defined(PENUMBRA_USES_PCSS)
#if defined(_PENUMBRA_PCSS_POISSON)
#include "Filters/PcssClassic.hlsl"
#elif defined(_PENUMBRA_PCSS_HDRP)
#include "Filters/PcssHdrp.hlsl"
#else
#include "Filters/PcssAngular.hlsl"
#endif
#elif defined(_PENUMBRA_HARD)
#include "Filters/HardTest.hlsl"
#elif defined(_PENUMBRA_BILINEAR) || defined(_PENUMBRA_FOUR_TAP)
#include "Filters/FixedPcf.hlsl"
#else
#include "Filters/TentPcf.hlsl"
#endif

float4 _PenumbraSamples;
float4 _PenumbraLimits;
float4 _PenumbraHdrp;

#if defined(PENUMBRA_USES_PCSS)
float PcssByKeyword(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                    ShadowReceiver receiver, ShadowTile tile)
{
#if defined(_PENUMBRA_PCSS_POISSON)
    PcssClassicParameters classic;
    classic.samples = int(_PenumbraSamples.x);
    classic.searchRadiusMetres = _PenumbraLimits.z;
    classic.minFilterTexels = _PenumbraSamples.w;
    return FilterPcssClassic(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                             classic);
#elif defined(_PENUMBRA_PCSS_HDRP)
    PcssHdrpParameters hdrp;
    hdrp.blockerSamples = int(_PenumbraSamples.x);
    hdrp.filterSamples = int(_PenumbraSamples.y);
    hdrp.blockerClump = _PenumbraSamples.z;
    hdrp.minFilterTexels = _PenumbraSamples.w;
    hdrp.maxPenumbraMetres = _PenumbraLimits.x;
    hdrp.maxSamplingMetres = _PenumbraLimits.y;
    hdrp.searchTanHalf = _PenumbraHdrp.x;
    hdrp.minFilterTanHalf = _PenumbraHdrp.y;
    return FilterPcssHdrp(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile, hdrp);
#else
    PcssAngularParameters angular;
    angular.blockerSamples = int(_PenumbraSamples.x);
    angular.filterSamples = int(_PenumbraSamples.y);
    angular.blockerClump = _PenumbraSamples.z;
    angular.minFilterTexels = _PenumbraSamples.w;
    angular.maxPenumbraMetres = _PenumbraLimits.x;
    angular.maxSamplingMetres = _PenumbraLimits.y;
    return FilterPcssAngular(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                             angular);
#endif
}
#endif

float FilterByKeyword(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                      ShadowReceiver receiver, ShadowTile tile)
{
#if defined(PENUMBRA_USES_PCSS)
    return PcssByKeyword(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile);
#elif defined(PENUMBRA_USES_TENT_7X7)
    return FilterTent7x7Plane(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#elif defined(_PENUMBRA_TENT_3X3)
    return FilterTent3x3Plane(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#elif defined(_PENUMBRA_HARD)
    return FilterHard(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#elif defined(_PENUMBRA_BILINEAR)
    return FilterBilinear(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#elif defined(_PENUMBRA_FOUR_TAP)
    return FilterFourTapPlane(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#else
    return FilterTent5x5Plane(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#endif
}

float PenumbraMainLightVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    const PenumbraMainLight shadow = PreparePenumbraMainLight(positionWS, normalWS, pixel);
    if (!shadow.covered) return 1.0;
    const float visibility =
        FilterByKeyword(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_PenumbraLinearClampCompare),
                        sampler_PenumbraPointClamp, shadow.receiver, shadow.tile);
    return ApplyPenumbraStrength(visibility);
}

#endif
