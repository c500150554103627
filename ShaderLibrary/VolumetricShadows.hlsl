// Penumbra: URP's main light along a view ray, for fog and shafts of light, in one include.
//
//   #pragma multi_compile_fragment _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN
//   #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
//   #include "Packages/com.penumbra.shadows/ShaderLibrary/VolumetricShadows.hlsl"
//   ...
//   float light = 1.0;
//   #if defined(MAIN_LIGHT_CALCULATE_SHADOWS)  // URP's, from its keywords: without one on, it has no shadow map
//   light = PenumbraMainLightFogVisibility(cameraWS, directionWS, lengthMetres, extinction, 16, GradientNoise(pixel,
//   0u)); #endif
//
// Computes:   PenumbraMainLightRayVisibility  the mean visibility of the main light along a segment
//             PenumbraMainLightFogVisibility  the same as homogeneous fog weighs it: its share of the light that the
//                                             fog scatters to the eye, of which 1 - exp(-extinction length) would
//                                             arrive without shadows
// Source:     Filters/Fixed/RayVisibility.hlsl.
// Inputs:     originWS, metres; directionWS, unit; lengthMetres: to the surface, or where the fog ends; extinction, per
//             metre; samples, 1 to 64; jitter, 0 to 1: 0.5 in the middle of equal parts, GradientNoise of the pixel
//             where a filter over the screen or over time follows. The uniforms of Pipelines/Urp.hlsl.
// Cost:       1 comparison for each sample within the shadow distance.
// Guarantees: [0, 1] for any input; lit beyond the last cascade. URP's shadow strength is applied, its distance fade is
//             not. Depths are compared, never read raw, so it is the same on OpenGL and WebGL.
// Use it:     in a pass over the screen at half or a quarter of its size, with rays that end at the shadow distance.
//             Not: for the shadows of surfaces (Shadows.hlsl).
#ifndef PENUMBRA_VOLUMETRIC_SHADOWS_HLSL
#define PENUMBRA_VOLUMETRIC_SHADOWS_HLSL

#include "Pipelines/Urp.hlsl"
#include "Filters/Fixed/RayVisibility.hlsl"

static const float kLongestRayMetres = 1e6;

TileSegment PenumbraMainLightSegmentIn(int cascade, int count, float3 originWS, float3 spanWS)
{
    const int held = min(cascade, count - 1);
    const float4x4 worldToShadow = PenumbraMainLightMatrix(held);
    const ShadowTile tile = PenumbraMainLightTile(worldToShadow, held, count, 0.0);
    return SegmentInTile(worldToShadow, tile, originWS, spanWS);
}

ShadowSegment PenumbraMainLightSegment(float3 originWS, float3 spanWS)
{
    const int count = PenumbraMainLightCascadeCount();
    ShadowSegment segment;
    segment.originWS = originWS;
    segment.spanWS = spanWS;
    segment.spheres = PenumbraMainLightSpheres();
    segment.cascades = count;
    segment.in0 = PenumbraMainLightSegmentIn(0, count, originWS, spanWS);
    segment.in1 = PenumbraMainLightSegmentIn(1, count, originWS, spanWS);
    segment.in2 = PenumbraMainLightSegmentIn(2, count, originWS, spanWS);
    segment.in3 = PenumbraMainLightSegmentIn(3, count, originWS, spanWS);
    return segment;
}

float PenumbraMainLightFogVisibility(float3 originWS, float3 directionWS, float lengthMetres, float extinction,
                                     int samples, float jitter)
{
    const float metres = BoundedOrLow(lengthMetres, 0.0, kLongestRayMetres);
    RaySampling sampling;
    sampling.samples = samples;
    sampling.jitter = jitter;
    sampling.opticalDepth = BoundedOrLow(extinction, 0.0, 1e6) * metres;
    const float visibility =
        RayVisibility(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_PenumbraLinearClampCompare),
                      PenumbraMainLightSegment(originWS, directionWS * metres), sampling);
    return SanitizeVisibility(ApplyPenumbraStrength(visibility));
}

float PenumbraMainLightRayVisibility(float3 originWS, float3 directionWS, float lengthMetres, int samples, float jitter)
{
    return PenumbraMainLightFogVisibility(originWS, directionWS, lengthMetres, 0.0, samples, jitter);
}

#endif
