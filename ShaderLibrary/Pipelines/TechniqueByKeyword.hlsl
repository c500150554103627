// Penumbra: the technique that a shader keyword selects.
//
// Computes:   visibility with the filter of the enabled keyword: _PENUMBRA_HARD, _PENUMBRA_BILINEAR,
//             _PENUMBRA_FOUR_TAP, _PENUMBRA_TENT_3X3, _PENUMBRA_TENT_7X7, _PENUMBRA_PCSS, _PENUMBRA_PCSS_POISSON,
//             _PENUMBRA_PCSS_HDRP; without a keyword, tent 5 x 5.
// Source:     see each filter's file.
// Inputs:     shadow map, its comparison and point samplers, ShadowReceiver, ShadowTile; uniforms
//             _PenumbraSamples: blocker samples, filter samples, blockerClump, smallest filter radius (texels);
//             _PenumbraLimits: widest penumbra (m), cone height (m), search radius of classic PCSS (m); HDRP's tangents
//             in _PenumbraHdrp.xy. Runtime/Parameters/ShadowUniforms.cs packs them.
// Cost:       the technique's fetches.
// Guarantees: [0, 1]. Only the file of the selected filter is included.
// Use it:     after a pipeline's bindings, as Shadows.hlsl and Hdrp.hlsl do. Not: directly from a shader.
#ifndef PENUMBRA_TECHNIQUE_BY_KEYWORD_HLSL
#define PENUMBRA_TECHNIQUE_BY_KEYWORD_HLSL

#include "../Core/ShadowStructs.hlsl"
#include "../Core/TechniqueParameters.hlsl"

// PCSS reads depths by gather from a texture whose sampler compares. That is undefined in OpenGL, OpenGL ES and WebGL,
// and before ES 3.1 there is no gather: the widest tent is used instead. Who binds the map without a comparison there
// defines PENUMBRA_RAW_DEPTH_READS.
#if !defined(PENUMBRA_RAW_DEPTH_READS) && \
    (defined(SHADER_API_GLCORE) || defined(SHADER_API_GLES) || defined(SHADER_API_GLES3) || defined(SHADER_API_WEBGL))
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
#include "../Filters/PcssClassic.hlsl"
#elif defined(_PENUMBRA_PCSS_HDRP)
#include "../Filters/PcssHdrp.hlsl"
#else
#include "../Filters/PcssAngular.hlsl"
#endif
#elif defined(_PENUMBRA_HARD)
#include "../Filters/HardTest.hlsl"
#elif defined(_PENUMBRA_BILINEAR) || defined(_PENUMBRA_FOUR_TAP)
#include "../Filters/FixedPcf.hlsl"
#else
#include "../Filters/TentPcf.hlsl"
#endif

float4 _PenumbraSamples;
float4 _PenumbraLimits;
float4 _PenumbraHdrp;

PcssAngularParameters PcssAngularOfUniforms()
{
    PcssAngularParameters angular;
    angular.blockerSamples = int(_PenumbraSamples.x);
    angular.filterSamples = int(_PenumbraSamples.y);
    angular.blockerClump = _PenumbraSamples.z;
    angular.minFilterTexels = _PenumbraSamples.w;
    angular.maxPenumbraMetres = _PenumbraLimits.x;
    angular.maxSamplingMetres = _PenumbraLimits.y;
    return angular;
}

PcssHdrpParameters PcssHdrpOfUniforms()
{
    PcssHdrpParameters hdrp;
    hdrp.blockerSamples = int(_PenumbraSamples.x);
    hdrp.filterSamples = int(_PenumbraSamples.y);
    hdrp.blockerClump = _PenumbraSamples.z;
    hdrp.minFilterTexels = _PenumbraSamples.w;
    hdrp.maxPenumbraMetres = _PenumbraLimits.x;
    hdrp.maxSamplingMetres = _PenumbraLimits.y;
    hdrp.searchTanHalf = _PenumbraHdrp.x;
    hdrp.minFilterTanHalf = _PenumbraHdrp.y;
    return hdrp;
}

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
    return FilterPcssHdrp(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                          PcssHdrpOfUniforms());
#else
    return FilterPcssAngular(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                             PcssAngularOfUniforms());
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

#endif
