// Penumbra: the technique that a shader keyword selects.
// Written by `penumbra validate --emit-keywords` from the manifests, *.technique.json; do not edit.
//
// Computes:   visibility with the filter of the enabled keyword:
//               _PENUMBRA_HARD          FilterHard          Filters/HardTest.hlsl
//               _PENUMBRA_BILINEAR      FilterBilinear      Filters/FixedPcf.hlsl
//               _PENUMBRA_FOUR_TAP      FilterFourTapPlane  Filters/FixedPcf.hlsl
//               _PENUMBRA_TENT_3X3      FilterTent3x3Plane  Filters/TentPcf.hlsl
//               _PENUMBRA_TENT_7X7      FilterTent7x7Plane  Filters/TentPcf.hlsl
//               _PENUMBRA_PCSS_POISSON  FilterPcssClassic   Filters/PcssClassic.hlsl
//               _PENUMBRA_PCSS          FilterPcssAngular   Filters/PcssAngular.hlsl
//               _PENUMBRA_PCSS_HDRP     FilterPcssHdrp      Filters/PcssHdrp.hlsl
//               none of them            FilterTent5x5Plane  Filters/TentPcf.hlsl
// Source:     see each filter's file.
// Inputs:     shadow map, its comparison and point samplers, ShadowReceiver, ShadowTile; the uniforms below, which the C#
//             structs of these names in Runtime/Parameters set; cascade: the receiver's cascade, for techniques with
//             rules for far cascades. The uniforms of a rule have its first cascade in their names.
// Cost:       the technique's fetches.
// Guarantees: [0, 1]. Only the file of the selected filter is included.
// Use it:     after a pipeline's bindings, as Shadows.hlsl and Hdrp.hlsl do. Not: directly from a shader.
#ifndef PENUMBRA_TECHNIQUE_BY_KEYWORD_HLSL
#define PENUMBRA_TECHNIQUE_BY_KEYWORD_HLSL

#include "../Core/ShadowStructs.hlsl"

// These filters gather raw depths from a texture that has a comparison sampler. That is undefined in OpenGL, OpenGL ES
// and WebGL, and before ES 3.1 there is no gather: a filter that only compares is used instead. Define
// PENUMBRA_RAW_DEPTH_READS where the map is bound without comparison there.
#if !defined(PENUMBRA_RAW_DEPTH_READS) && \
    (defined(SHADER_API_GLCORE) || defined(SHADER_API_GLES) || defined(SHADER_API_GLES3) || defined(SHADER_API_WEBGL))
#define PENUMBRA_WITHOUT_GATHER
#endif

#if defined(PENUMBRA_WITHOUT_GATHER) && \
    (defined(_PENUMBRA_PCSS_POISSON) || defined(_PENUMBRA_PCSS) || defined(_PENUMBRA_PCSS_HDRP))
#define PENUMBRA_USES_TENT_7X7
#elif defined(_PENUMBRA_HARD)
#define PENUMBRA_USES_HARD
#elif defined(_PENUMBRA_BILINEAR)
#define PENUMBRA_USES_BILINEAR
#elif defined(_PENUMBRA_FOUR_TAP)
#define PENUMBRA_USES_FOUR_TAP
#elif defined(_PENUMBRA_TENT_3X3)
#define PENUMBRA_USES_TENT_3X3
#elif defined(_PENUMBRA_TENT_7X7)
#define PENUMBRA_USES_TENT_7X7
#elif defined(_PENUMBRA_PCSS_POISSON)
#define PENUMBRA_USES_PCSS_POISSON
#define PENUMBRA_READS_RAW_DEPTH
#elif defined(_PENUMBRA_PCSS)
#define PENUMBRA_USES_PCSS
#define PENUMBRA_READS_RAW_DEPTH
#elif defined(_PENUMBRA_PCSS_HDRP)
#define PENUMBRA_USES_PCSS_HDRP
#define PENUMBRA_READS_RAW_DEPTH
#endif

#if defined(PENUMBRA_USES_HARD)
#include "../Filters/HardTest.hlsl"
#elif defined(PENUMBRA_USES_BILINEAR)
#include "../Filters/FixedPcf.hlsl"
#elif defined(PENUMBRA_USES_FOUR_TAP)
#include "../Filters/FixedPcf.hlsl"
#elif defined(PENUMBRA_USES_TENT_3X3)
#include "../Filters/TentPcf.hlsl"
#elif defined(PENUMBRA_USES_TENT_7X7)
#include "../Filters/TentPcf.hlsl"
#elif defined(PENUMBRA_USES_PCSS_POISSON)
#include "../Filters/PcssClassic.hlsl"
#elif defined(PENUMBRA_USES_PCSS)
#include "../Filters/PcssAngular.hlsl"
#elif defined(PENUMBRA_USES_PCSS_HDRP)
#include "../Filters/PcssHdrp.hlsl"
#else
#include "../Filters/TentPcf.hlsl"
#endif

#include "../Filters/PcssClassicParameters.hlsl"
float4 _PenumbraPcssClassicParameters0;

PcssClassicParameters PenumbraPcssClassic()
{
    return UnpackPcssClassicParameters(_PenumbraPcssClassicParameters0);
}

#include "../Filters/PcssAngularParameters.hlsl"
float4 _PenumbraPcssAngularParameters0;
float4 _PenumbraPcssAngularParameters1;

PcssAngularParameters PenumbraPcssAngular()
{
    return UnpackPcssAngularParameters(_PenumbraPcssAngularParameters0, _PenumbraPcssAngularParameters1);
}

#include "../Filters/PcssHdrpParameters.hlsl"
float4 _PenumbraPcssHdrpParameters0;
float4 _PenumbraPcssHdrpParameters1;

PcssHdrpParameters PenumbraPcssHdrp()
{
    return UnpackPcssHdrpParameters(_PenumbraPcssHdrpParameters0, _PenumbraPcssHdrpParameters1);
}

float FilterByKeyword(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                      ShadowReceiver receiver, ShadowTile tile, int cascade)
{
#if defined(PENUMBRA_USES_HARD)
    return FilterHard(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#elif defined(PENUMBRA_USES_BILINEAR)
    return FilterBilinear(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#elif defined(PENUMBRA_USES_FOUR_TAP)
    return FilterFourTapPlane(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#elif defined(PENUMBRA_USES_TENT_3X3)
    return FilterTent3x3Plane(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#elif defined(PENUMBRA_USES_TENT_7X7)
    return FilterTent7x7Plane(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#elif defined(PENUMBRA_USES_PCSS_POISSON)
    return FilterPcssClassic(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                             PenumbraPcssClassic());
#elif defined(PENUMBRA_USES_PCSS)
    return FilterPcssAngular(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                             PenumbraPcssAngular());
#elif defined(PENUMBRA_USES_PCSS_HDRP)
    return FilterPcssHdrp(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                          PenumbraPcssHdrp());
#else
    return FilterTent5x5Plane(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#endif
}

#endif
