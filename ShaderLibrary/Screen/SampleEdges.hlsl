// Penumbra: pixels of a multisampled picture whose samples see several surfaces.
//
// Computes:   in two steps whether one visibility is enough for all samples of a pixel.
//
//                 +-------+      step 1: not all samples hold the same value: several triangles meet here
//                 | a   b |      step 2: the surfaces of two samples lie apart, or face different ways;
//                 |   b b |              triangles of one smooth surface do not
//                 +-------+
//
// Source:     marking passes before deferred MSAA shading, which is done per sample at marked pixels only: Lauritzen,
//             "Deferred Rendering for Current and Future Rendering Pipelines" (SIGGRAPH course 2010); in two passes:
//             Red Dead Redemption 2.
// Inputs:     normals: xyz the world normal of each sample's surface, of any length and either sign, 0 where there is
//             none; written once per triangle and pixel, so that samples of one triangle hold equal values. depths:
//             stored camera depth of each sample. ScreenView of the camera; EdgeParameters.
// Cost:       step 1: as many fetches as samples, fewer where the first two differ; step 2: up to twice as many.
// Guarantees: step 1 marks every pixel that two triangles share, unless both have the same normal. A NaN marks. Sky
//             beside a surface is an edge. Up to kMostSamples samples; of more the first ones.
// Use it:     before shading marked pixels per sample. Not: without multisampling.
#ifndef PENUMBRA_SAMPLE_EDGES_HLSL
#define PENUMBRA_SAMPLE_EDGES_HLSL

#include "CameraSurface.hlsl"
#include "Parameters/EdgeParameters.hlsl"

static const int kMostSamples = 8;

// These are where the samples lie, in 16ths of a pixel from its centre, y in the order of rows, in the standard
// patterns of Direct3D, Vulkan and Metal. OpenGL does not prescribe any.
static const int2 kTwoSamples[2] = {int2(4, 4), int2(-4, -4)};
static const int2 kFourSamples[4] = {int2(-2, -6), int2(6, -2), int2(-6, 2), int2(2, 6)};
static const int2 kEightSamples[8] = {int2(1, -3), int2(-1, 3), int2(5, 1),  int2(-3, -5),
                                      int2(-5, 5), int2(-7, -1), int2(3, 7), int2(7, -7)};

// The place of one of a pixel's `samples` samples, in pixels from its centre; 0 for a number without a standard
// pattern.
float2 SampleOffset(int samples, int index)
{
    int2 sixteenths = int2(0, 0);
    if (samples == 2) sixteenths = kTwoSamples[index & 1];
    if (samples == 4) sixteenths = kFourSamples[index & 3];
    if (samples == 8) sixteenths = kEightSamples[index & 7];
    return float2(sixteenths) / 16.0;
}

// The surface that one sample sees.
struct SampleSurface
{
    bool seen;
    float3 positionWS;    // metres
    float3 normalWS;      // unit; 0 where it is not known
    float metresPerPixel; // width of a pixel in the plane of equal depth
};

// uv is where the sample lies, not the pixel's centre.
SampleSurface SurfaceOfSample(ScreenView view, float2 uv, float depth, float3 normal)
{
    const ScreenPoint at = ScreenPointOf(view.screenToWorld, uv, depth);
    const float squared = dot(normal, normal);
    SampleSurface surface;
    surface.seen = IsSurfaceDepth(depth);
    surface.positionWS = at.positionWS;
    surface.normalWS = squared > 0.0 ? normal * rsqrt(squared) : float3(0.0, 0.0, 0.0);
    surface.metresPerPixel = MetresPerPixel(view.screenToWorld, at, view.size.zw);
    return surface;
}

// Step 1 of the file's header.
bool SamplesDiffer(TEXTURE2D_X_MSAA(float4, normals), int2 pixel, int samples)
{
    const float3 first = LOAD_TEXTURE2D_X_MSAA(normals, pixel, 0).xyz;
    UNITY_LOOP
    for (int i = 1; i < min(samples, kMostSamples); ++i)
    {
        const float3 other = LOAD_TEXTURE2D_X_MSAA(normals, pixel, i).xyz;
        if (!all(other == first)) return true;
    }
    return false;
}

// Step 2 of the file's header, for two samples; their order does not matter.
bool SurfacesDiffer(SampleSurface a, SampleSurface b, EdgeParameters parameters)
{
    if (a.seen != b.seen) return true;
    if (!a.seen) return false;
    if (!(dot(a.normalWS, b.normalWS) >= parameters.normalCosine)) return true;
    const float3 between = b.positionWS - a.positionWS;
    const float apart = max(abs(dot(between, a.normalWS)), abs(dot(between, b.normalWS)));
    return !(apart <= parameters.depthTolerance * min(a.metresPerPixel, b.metresPerPixel));
}

#endif
