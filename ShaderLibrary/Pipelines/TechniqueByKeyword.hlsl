// Penumbra: the technique that a shader keyword selects.
// Written by `penumbra emit` from the manifests, *.technique.json; do not edit.
//
// Computes:   visibility with the filter of the enabled keyword:
//               _PENUMBRA_HARD                 FilterHard                 Filters/Fixed/HardTest.hlsl
//               _PENUMBRA_BILINEAR             FilterBilinear             Filters/Fixed/FixedPcf.hlsl
//               _PENUMBRA_FOUR_TAP             FilterFourTapPlane         Filters/Fixed/FixedPcf.hlsl
//               _PENUMBRA_TENT_3X3             FilterTent3x3Plane         Filters/Fixed/TentPcf.hlsl
//               _PENUMBRA_TENT_7X7             FilterTent7x7Plane         Filters/Fixed/TentPcf.hlsl
//               _PENUMBRA_PCSS_POISSON         FilterPcssClassic          Filters/Pcss/PcssClassic.hlsl
//               _PENUMBRA_PCSS                 FilterPcssAngular          Filters/Pcss/PcssAngular.hlsl
//               _PENUMBRA_PCSS_BOUNDED         FilterPcssBounded          Filters/Pcss/PcssBounded.hlsl
//               _PENUMBRA_PCSS_HDRP            FilterPcssHdrp             Filters/Peers/PcssHdrp.hlsl
//               _PENUMBRA_VSM                  FilterVariance             Filters/Prefiltered/Variance.hlsl
//               _PENUMBRA_ESM                  FilterExponential          Filters/Prefiltered/Exponential.hlsl
//               _PENUMBRA_ESM_LOG              FilterLogExponential       Filters/Prefiltered/LogExponential.hlsl
//               _PENUMBRA_EVSM                 FilterExponentialVariance  Filters/Prefiltered/ExponentialVariance.hlsl
//               _PENUMBRA_MSM                  FilterMoments              Filters/Prefiltered/MomentShadows.hlsl
//               _PENUMBRA_SMRT                 FilterUnrealSmrt           Filters/Peers/UnrealSmrt.hlsl
//               _PENUMBRA_PCSS_GODOT           FilterGodotPcss            Filters/Peers/GodotPcss.hlsl
//               _PENUMBRA_DPCF_FILAMENT        FilterFilamentDpcf         Filters/Peers/FilamentDpcf.hlsl
//               _PENUMBRA_PCSS_FILAMENT        FilterFilamentPcss         Filters/Peers/FilamentPcss.hlsl
//               _PENUMBRA_SINGLE_LOOP          FilterSingleLoop           Filters/SingleLoop/SingleLoop.hlsl
//               _PENUMBRA_SINGLE_LOOP_MIN_MAX  FilterSingleLoopMinMax     Filters/SingleLoop/SingleLoopRanges.hlsl
//               _PENUMBRA_SINGLE_LOOP_MIPS     FilterSingleLoopMips       Filters/SingleLoop/SingleLoopRanges.hlsl
//               _PENUMBRA_SINGLE_LOOP_PLANES   FilterSingleLoopPlanes     Filters/SingleLoop/SingleLoopPlanes.hlsl
//               _PENUMBRA_VSSM                 FilterVssmSums             Filters/Prefiltered/VssmSums.hlsl
//               _PENUMBRA_VSSM_MIPS            FilterVssmLevels           Filters/Prefiltered/VssmLevels.hlsl
//               _PENUMBRA_MSSM                 FilterMssmSums             Filters/Prefiltered/MssmSums.hlsl
//               _PENUMBRA_MSSM_MIPS            FilterMssmLevels           Filters/Prefiltered/MssmLevels.hlsl
//               _PENUMBRA_EVSM_MIPS            FilterExponentialLevels    Filters/Prefiltered/ExponentialLevels.hlsl
//               none of them                   FilterTent5x5Plane         Filters/Fixed/TentPcf.hlsl
// Source:     see each filter's file.
// Inputs:     shadow map, its comparison and point samplers, ShadowReceiver, ShadowTile; the uniforms below, which the
//             C# structs of these names in Runtime/Parameters set; cascade: the receiver's cascade, for techniques with
//             rules for far cascades. The uniforms of a rule have its first cascade in their names. Some filters read
//             maps that passes make from the shadow map, the textures below: those are for the renderer feature's own
//             screen pass. Other shaders get an error, unless they define PENUMBRA_MAPS_BOUND and are drawn after
//             these passes, while the feature's technique is the keyword's or one that publishes the same maps.
// Cost:       the technique's fetches.
// Guarantees: [0, 1]. Only the file of the selected filter is included.
// Use it:     after a pipeline's bindings, as Shadows.hlsl and Hdrp.hlsl do. Not: directly from a shader.
#ifndef PENUMBRA_TECHNIQUE_BY_KEYWORD_HLSL
#define PENUMBRA_TECHNIQUE_BY_KEYWORD_HLSL

#include "../Core/ShadowStructs.hlsl"

// These filters, or the passes before them, read raw depths from a texture that has a comparison sampler. That is
// undefined in OpenGL, OpenGL ES and WebGL, and before ES 3.1 there is no gather: a filter that only compares is used
// instead; on WebGPU too, where no frame was seen yet. Define PENUMBRA_RAW_DEPTH_READS where the map is bound without
// comparison there.
#if !defined(PENUMBRA_RAW_DEPTH_READS) && \
    (defined(SHADER_API_GLCORE) || defined(SHADER_API_GLES) || defined(SHADER_API_GLES3) || \
     defined(SHADER_API_WEBGL) || defined(SHADER_API_WEBGPU))
#define PENUMBRA_WITHOUT_GATHER
#endif

#if defined(PENUMBRA_WITHOUT_GATHER) && \
    (defined(_PENUMBRA_PCSS_POISSON) || defined(_PENUMBRA_PCSS) || defined(_PENUMBRA_PCSS_BOUNDED) || \
     defined(_PENUMBRA_PCSS_HDRP) || defined(_PENUMBRA_VSM) || defined(_PENUMBRA_ESM) || \
     defined(_PENUMBRA_ESM_LOG) || defined(_PENUMBRA_EVSM) || defined(_PENUMBRA_MSM) || \
     defined(_PENUMBRA_SMRT) || defined(_PENUMBRA_PCSS_GODOT) || defined(_PENUMBRA_DPCF_FILAMENT) || \
     defined(_PENUMBRA_PCSS_FILAMENT) || defined(_PENUMBRA_SINGLE_LOOP) || \
     defined(_PENUMBRA_SINGLE_LOOP_MIN_MAX) || defined(_PENUMBRA_SINGLE_LOOP_MIPS) || \
     defined(_PENUMBRA_SINGLE_LOOP_PLANES) || defined(_PENUMBRA_VSSM) || defined(_PENUMBRA_VSSM_MIPS) || \
     defined(_PENUMBRA_MSSM) || defined(_PENUMBRA_MSSM_MIPS) || defined(_PENUMBRA_EVSM_MIPS))
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
#elif defined(_PENUMBRA_PCSS_BOUNDED)
#define PENUMBRA_USES_PCSS_BOUNDED
#define PENUMBRA_READS_RAW_DEPTH
#elif defined(_PENUMBRA_PCSS_HDRP)
#define PENUMBRA_USES_PCSS_HDRP
#define PENUMBRA_READS_RAW_DEPTH
#elif defined(_PENUMBRA_VSM)
#define PENUMBRA_USES_VSM
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_ESM)
#define PENUMBRA_USES_ESM
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_ESM_LOG)
#define PENUMBRA_USES_ESM_LOG
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_EVSM)
#define PENUMBRA_USES_EVSM
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_MSM)
#define PENUMBRA_USES_MSM
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_SMRT)
#define PENUMBRA_USES_SMRT
#define PENUMBRA_READS_RAW_DEPTH
#elif defined(_PENUMBRA_PCSS_GODOT)
#define PENUMBRA_USES_PCSS_GODOT
#define PENUMBRA_READS_RAW_DEPTH
#elif defined(_PENUMBRA_DPCF_FILAMENT)
#define PENUMBRA_USES_DPCF_FILAMENT
#define PENUMBRA_READS_RAW_DEPTH
#elif defined(_PENUMBRA_PCSS_FILAMENT)
#define PENUMBRA_USES_PCSS_FILAMENT
#define PENUMBRA_READS_RAW_DEPTH
#elif defined(_PENUMBRA_SINGLE_LOOP)
#define PENUMBRA_USES_SINGLE_LOOP
#define PENUMBRA_READS_RAW_DEPTH
#elif defined(_PENUMBRA_SINGLE_LOOP_MIN_MAX)
#define PENUMBRA_USES_SINGLE_LOOP_MIN_MAX
#define PENUMBRA_READS_RAW_DEPTH
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_SINGLE_LOOP_MIPS)
#define PENUMBRA_USES_SINGLE_LOOP_MIPS
#define PENUMBRA_READS_RAW_DEPTH
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_SINGLE_LOOP_PLANES)
#define PENUMBRA_USES_SINGLE_LOOP_PLANES
#define PENUMBRA_READS_RAW_DEPTH
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_VSSM)
#define PENUMBRA_USES_VSSM
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_VSSM_MIPS)
#define PENUMBRA_USES_VSSM_MIPS
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_MSSM)
#define PENUMBRA_USES_MSSM
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_MSSM_MIPS)
#define PENUMBRA_USES_MSSM_MIPS
#define PENUMBRA_READS_MAPS
#elif defined(_PENUMBRA_EVSM_MIPS)
#define PENUMBRA_USES_EVSM_MIPS
#define PENUMBRA_READS_MAPS
#endif

// The renderer feature's passes bind these maps while its technique is this keyword's.
#if defined(PENUMBRA_READS_MAPS) && !defined(PENUMBRA_MAPS_BOUND)
#error "this keyword's filter reads maps that only the renderer feature's passes make: choose another, or define PENUMBRA_MAPS_BOUND where they are bound"
#endif

#if defined(PENUMBRA_USES_HARD)
#include "../Filters/Fixed/HardTest.hlsl"
#elif defined(PENUMBRA_USES_BILINEAR)
#include "../Filters/Fixed/FixedPcf.hlsl"
#elif defined(PENUMBRA_USES_FOUR_TAP)
#include "../Filters/Fixed/FixedPcf.hlsl"
#elif defined(PENUMBRA_USES_TENT_3X3)
#include "../Filters/Fixed/TentPcf.hlsl"
#elif defined(PENUMBRA_USES_TENT_7X7)
#include "../Filters/Fixed/TentPcf.hlsl"
#elif defined(PENUMBRA_USES_PCSS_POISSON)
#include "../Filters/Pcss/PcssClassic.hlsl"
#elif defined(PENUMBRA_USES_PCSS)
#include "../Filters/Pcss/PcssAngular.hlsl"
#elif defined(PENUMBRA_USES_PCSS_BOUNDED)
#include "../Filters/Pcss/PcssBounded.hlsl"
#elif defined(PENUMBRA_USES_PCSS_HDRP)
#include "../Filters/Peers/PcssHdrp.hlsl"
#elif defined(PENUMBRA_USES_VSM)
#include "../Filters/Prefiltered/Variance.hlsl"
#elif defined(PENUMBRA_USES_ESM)
#include "../Filters/Prefiltered/Exponential.hlsl"
#elif defined(PENUMBRA_USES_ESM_LOG)
#include "../Filters/Prefiltered/LogExponential.hlsl"
#elif defined(PENUMBRA_USES_EVSM)
#include "../Filters/Prefiltered/ExponentialVariance.hlsl"
#elif defined(PENUMBRA_USES_MSM)
#include "../Filters/Prefiltered/MomentShadows.hlsl"
#elif defined(PENUMBRA_USES_SMRT)
#include "../Filters/Peers/UnrealSmrt.hlsl"
#elif defined(PENUMBRA_USES_PCSS_GODOT)
#include "../Filters/Peers/GodotPcss.hlsl"
#elif defined(PENUMBRA_USES_DPCF_FILAMENT)
#include "../Filters/Peers/FilamentDpcf.hlsl"
#elif defined(PENUMBRA_USES_PCSS_FILAMENT)
#include "../Filters/Peers/FilamentPcss.hlsl"
#elif defined(PENUMBRA_USES_SINGLE_LOOP)
#include "../Filters/SingleLoop/SingleLoop.hlsl"
#elif defined(PENUMBRA_USES_SINGLE_LOOP_MIN_MAX)
#include "../Filters/SingleLoop/SingleLoopRanges.hlsl"
#elif defined(PENUMBRA_USES_SINGLE_LOOP_MIPS)
#include "../Filters/SingleLoop/SingleLoopRanges.hlsl"
#elif defined(PENUMBRA_USES_SINGLE_LOOP_PLANES)
#include "../Filters/SingleLoop/SingleLoopPlanes.hlsl"
#elif defined(PENUMBRA_USES_VSSM)
#include "../Filters/Prefiltered/VssmSums.hlsl"
#elif defined(PENUMBRA_USES_VSSM_MIPS)
#include "../Filters/Prefiltered/VssmLevels.hlsl"
#elif defined(PENUMBRA_USES_MSSM)
#include "../Filters/Prefiltered/MssmSums.hlsl"
#elif defined(PENUMBRA_USES_MSSM_MIPS)
#include "../Filters/Prefiltered/MssmLevels.hlsl"
#elif defined(PENUMBRA_USES_EVSM_MIPS)
#include "../Filters/Prefiltered/ExponentialLevels.hlsl"
#else
#include "../Filters/Fixed/TentPcf.hlsl"
#endif

#if defined(PENUMBRA_USES_VSM)
SAMPLER(sampler_PenumbraLinearClamp);
TEXTURE2D(_PenumbraMomentsTexture);
#elif defined(PENUMBRA_USES_ESM)
SAMPLER(sampler_PenumbraLinearClamp);
TEXTURE2D(_PenumbraExponentialsTexture);
#elif defined(PENUMBRA_USES_ESM_LOG)
TEXTURE2D(_PenumbraSoftDepthsTexture);
#elif defined(PENUMBRA_USES_EVSM)
SAMPLER(sampler_PenumbraLinearClamp);
TEXTURE2D(_PenumbraMomentsTexture);
#elif defined(PENUMBRA_USES_MSM)
SAMPLER(sampler_PenumbraLinearClamp);
TEXTURE2D(_PenumbraMomentsTexture);
#elif defined(PENUMBRA_USES_SINGLE_LOOP_MIN_MAX)
TEXTURE2D(_PenumbraDepthRangesTexture);
#elif defined(PENUMBRA_USES_SINGLE_LOOP_MIPS)
TEXTURE2D(_PenumbraDepthRangesTexture);
#elif defined(PENUMBRA_USES_SINGLE_LOOP_PLANES)
TEXTURE2D(_PenumbraDepthPlanesTexture);
#elif defined(PENUMBRA_USES_VSSM)
Texture2D<uint4> _PenumbraSumsTexture;
#elif defined(PENUMBRA_USES_VSSM_MIPS)
SAMPLER(sampler_PenumbraLinearClamp);
TEXTURE2D(_PenumbraMomentsTexture);
#elif defined(PENUMBRA_USES_MSSM)
Texture2D<uint4> _PenumbraSumsTexture;
#elif defined(PENUMBRA_USES_MSSM_MIPS)
SAMPLER(sampler_PenumbraLinearClamp);
TEXTURE2D(_PenumbraMomentsTexture);
#elif defined(PENUMBRA_USES_EVSM_MIPS)
SAMPLER(sampler_PenumbraLinearClamp);
TEXTURE2D(_PenumbraMomentsTexture);
#endif

#include "../Filters/Pcss/Parameters/PcssClassicParameters.hlsl"
float4 _PenumbraPcssClassicParameters0;

PcssClassicParameters PenumbraPcssClassic()
{
    return UnpackPcssClassicParameters(_PenumbraPcssClassicParameters0);
}

#include "../Filters/Pcss/Parameters/PcssAngularParameters.hlsl"
float4 _PenumbraPcssAngularParameters0;
float4 _PenumbraPcssAngularParameters1;

PcssAngularParameters PenumbraPcssAngular()
{
    return UnpackPcssAngularParameters(_PenumbraPcssAngularParameters0, _PenumbraPcssAngularParameters1);
}

#include "../Filters/Pcss/Parameters/PcssBoundedParameters.hlsl"
float4 _PenumbraPcssBoundedParameters0;

PcssBoundedParameters PenumbraPcssBounded()
{
    return UnpackPcssBoundedParameters(_PenumbraPcssBoundedParameters0);
}

#include "../Filters/Peers/Parameters/PcssHdrpParameters.hlsl"
float4 _PenumbraPcssHdrpParameters0;
float4 _PenumbraPcssHdrpParameters1;

PcssHdrpParameters PenumbraPcssHdrp()
{
    return UnpackPcssHdrpParameters(_PenumbraPcssHdrpParameters0, _PenumbraPcssHdrpParameters1);
}

#include "../Filters/Prefiltered/Parameters/VarianceParameters.hlsl"
float4 _PenumbraVarianceParameters0;

VarianceParameters PenumbraVariance()
{
    return UnpackVarianceParameters(_PenumbraVarianceParameters0);
}

#include "../Filters/Prefiltered/Parameters/ExponentialParameters.hlsl"
float4 _PenumbraExponentialParameters0;

ExponentialParameters PenumbraExponential()
{
    return UnpackExponentialParameters(_PenumbraExponentialParameters0);
}

#include "../Filters/Prefiltered/Parameters/LogExponentialParameters.hlsl"
float4 _PenumbraLogExponentialParameters0;

LogExponentialParameters PenumbraLogExponential()
{
    return UnpackLogExponentialParameters(_PenumbraLogExponentialParameters0);
}

#include "../Filters/Prefiltered/Parameters/ExponentialVarianceParameters.hlsl"
float4 _PenumbraExponentialVarianceParameters0;

ExponentialVarianceParameters PenumbraExponentialVariance()
{
    return UnpackExponentialVarianceParameters(_PenumbraExponentialVarianceParameters0);
}

#include "../Filters/Prefiltered/Parameters/MomentShadowsParameters.hlsl"
float4 _PenumbraMomentShadowsParameters0;

MomentShadowsParameters PenumbraMomentShadows()
{
    return UnpackMomentShadowsParameters(_PenumbraMomentShadowsParameters0);
}

#include "../Filters/Peers/Parameters/UnrealSmrtParameters.hlsl"
float4 _PenumbraUnrealSmrtParameters0;
float4 _PenumbraUnrealSmrtParameters1;

UnrealSmrtParameters PenumbraUnrealSmrt()
{
    return UnpackUnrealSmrtParameters(_PenumbraUnrealSmrtParameters0, _PenumbraUnrealSmrtParameters1);
}

#include "../Filters/Peers/Parameters/GodotPcssParameters.hlsl"
float4 _PenumbraGodotPcssParameters0;

GodotPcssParameters PenumbraGodotPcss()
{
    return UnpackGodotPcssParameters(_PenumbraGodotPcssParameters0);
}

#include "../Filters/Peers/Parameters/FilamentParameters.hlsl"
float4 _PenumbraFilamentParameters0;
float4 _PenumbraFilamentParameters1;

FilamentParameters PenumbraFilament()
{
    return UnpackFilamentParameters(_PenumbraFilamentParameters0, _PenumbraFilamentParameters1);
}

#include "../Filters/SingleLoop/Parameters/SingleLoopParameters.hlsl"
float4 _PenumbraSingleLoopParameters0;
float4 _PenumbraSingleLoopParameters1;

SingleLoopParameters PenumbraSingleLoop()
{
    return UnpackSingleLoopParameters(_PenumbraSingleLoopParameters0, _PenumbraSingleLoopParameters1);
}

#include "../Filters/Prefiltered/Parameters/VssmParameters.hlsl"
float4 _PenumbraVssmParameters0;
float4 _PenumbraVssmParameters1;

VssmParameters PenumbraVssm()
{
    return UnpackVssmParameters(_PenumbraVssmParameters0, _PenumbraVssmParameters1);
}

#include "../Filters/Prefiltered/Parameters/MssmParameters.hlsl"
float4 _PenumbraMssmParameters0;
float4 _PenumbraMssmParameters1;

MssmParameters PenumbraMssm()
{
    return UnpackMssmParameters(_PenumbraMssmParameters0, _PenumbraMssmParameters1);
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
#elif defined(PENUMBRA_USES_PCSS_BOUNDED)
    return FilterPcssBounded(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                             PenumbraPcssBounded());
#elif defined(PENUMBRA_USES_PCSS_HDRP)
    return FilterPcssHdrp(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                          PenumbraPcssHdrp());
#elif defined(PENUMBRA_USES_VSM)
    return FilterVariance(_PenumbraMomentsTexture, sampler_PenumbraLinearClamp, receiver, tile,
                          PenumbraVariance());
#elif defined(PENUMBRA_USES_ESM)
    return FilterExponential(_PenumbraExponentialsTexture, sampler_PenumbraLinearClamp, receiver, tile,
                             PenumbraExponential());
#elif defined(PENUMBRA_USES_ESM_LOG)
    return FilterLogExponential(_PenumbraSoftDepthsTexture, sampler_point, receiver, tile,
                                PenumbraLogExponential());
#elif defined(PENUMBRA_USES_EVSM)
    return FilterExponentialVariance(_PenumbraMomentsTexture, sampler_PenumbraLinearClamp, receiver, tile,
                                     PenumbraExponentialVariance());
#elif defined(PENUMBRA_USES_MSM)
    return FilterMoments(_PenumbraMomentsTexture, sampler_PenumbraLinearClamp, receiver, tile,
                         PenumbraMomentShadows());
#elif defined(PENUMBRA_USES_SMRT)
    return FilterUnrealSmrt(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                            PenumbraUnrealSmrt());
#elif defined(PENUMBRA_USES_PCSS_GODOT)
    return FilterGodotPcss(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                           PenumbraGodotPcss());
#elif defined(PENUMBRA_USES_DPCF_FILAMENT)
    return FilterFilamentDpcf(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                              PenumbraFilament());
#elif defined(PENUMBRA_USES_PCSS_FILAMENT)
    return FilterFilamentPcss(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                              PenumbraFilament());
#elif defined(PENUMBRA_USES_SINGLE_LOOP)
    return FilterSingleLoop(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point, receiver, tile,
                            PenumbraSingleLoop());
#elif defined(PENUMBRA_USES_SINGLE_LOOP_MIN_MAX)
    return FilterSingleLoopMinMax(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point,
                                  _PenumbraDepthRangesTexture, receiver, tile,
                                  PenumbraSingleLoop());
#elif defined(PENUMBRA_USES_SINGLE_LOOP_MIPS)
    return FilterSingleLoopMips(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point,
                                _PenumbraDepthRangesTexture, receiver, tile,
                                PenumbraSingleLoop());
#elif defined(PENUMBRA_USES_SINGLE_LOOP_PLANES)
    return FilterSingleLoopPlanes(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), sampler_point,
                                  _PenumbraDepthPlanesTexture, receiver, tile,
                                  PenumbraSingleLoop());
#elif defined(PENUMBRA_USES_VSSM)
    return FilterVssmSums(_PenumbraSumsTexture, receiver, tile,
                          PenumbraVssm());
#elif defined(PENUMBRA_USES_VSSM_MIPS)
    return FilterVssmLevels(_PenumbraMomentsTexture, sampler_PenumbraLinearClamp, receiver, tile,
                            PenumbraVssm());
#elif defined(PENUMBRA_USES_MSSM)
    return FilterMssmSums(_PenumbraSumsTexture, receiver, tile,
                          PenumbraMssm());
#elif defined(PENUMBRA_USES_MSSM_MIPS)
    return FilterMssmLevels(_PenumbraMomentsTexture, sampler_PenumbraLinearClamp, receiver, tile,
                            PenumbraMssm());
#elif defined(PENUMBRA_USES_EVSM_MIPS)
    return FilterExponentialLevels(_PenumbraMomentsTexture, sampler_PenumbraLinearClamp, receiver, tile,
                                   PenumbraExponentialVariance());
#else
    return FilterTent5x5Plane(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile);
#endif
}

#endif
