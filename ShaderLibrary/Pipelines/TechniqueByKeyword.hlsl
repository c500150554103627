// Penumbra: the technique that a shader keyword selects.
//
// Computes:   visibility with the filter of the enabled keyword: _PENUMBRA_HARD, _PENUMBRA_BILINEAR,
//             _PENUMBRA_FOUR_TAP, _PENUMBRA_TENT_3X3, _PENUMBRA_TENT_7X7, _PENUMBRA_PCSS, _PENUMBRA_PCSS_POISSON,
//             _PENUMBRA_PCSS_HDRP; without a keyword, tent 5 x 5.
// Source:     see each filter's file.
// Inputs:     shadow map, its comparison and point samplers, ShadowReceiver, ShadowTile; of PCSS the uniforms
//             _PenumbraPcssAngularParameters0, _PenumbraPcssClassicParameters0, _PenumbraPcssHdrpParameters0 and their like,
//             which the C# structs of these names in Runtime/Parameters fill.
// Cost:       the technique's fetches.
// Guarantees: [0, 1]. Only the file of the selected filter is included.
// Use it:     after a pipeline's bindings, as Shadows.hlsl and Hdrp.hlsl do. Not: directly from a shader.
#ifndef PENUMBRA_TECHNIQUE_BY_KEYWORD_HLSL
#define PENUMBRA_TECHNIQUE_BY_KEYWORD_HLSL

#include "../Core/ShadowStructs.hlsl"

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

#if defined(PENUMBRA_USES_PCSS)
#include "../Filters/PcssAngularParameters.hlsl"
float4 _PenumbraPcssAngularParameters0;
float4 _PenumbraPcssAngularParameters1;

PcssAngularParameters PenumbraPcssAngular()
{
    return UnpackPcssAngularParameters(_PenumbraPcssAngularParameters0, _PenumbraPcssAngularParameters1);
}
#endif

#include "../Filters/PcssHdrpParameters.hlsl"
float4 _PenumbraPcssHdrpParameters0;
float4 _PenumbraPcssHdrpParameters1;

PcssHdrpParameters PenumbraPcssHdrp()
{
    return UnpackPcssHdrpParameters(_PenumbraPcssHdrpParameters0, _PenumbraPcssHdrpParameters1);
}

#if defined(PENUMBRA_USES_PCSS) && defined(_PENUMBRA_PCSS_POISSON)
float4 _PenumbraPcssClassicParameters0;

PcssClassicParameters PenumbraPcssClassic()
{
    return UnpackPcssClassicParameters(_PenumbraPcssClassicParameters0);
}
#endif

#if defined(PENUMBRA_USES_PCSS)
float PcssByKeyword(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                    ShadowReceiver receiver, ShadowTile tile)
{
#if defined(_PENUMBRA_PCSS_POISSON)
    return FilterPcssClassic(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                             PenumbraPcssClassic());
#elif defined(_PENUMBRA_PCSS_HDRP)
    return FilterPcssHdrp(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                          PenumbraPcssHdrp());
#else
    return FilterPcssAngular(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                             PenumbraPcssAngular());
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
