// Penumbra: shadows of a multisampled picture: once for a pixel, and for each sample where a pixel has an edge.
//
// Computes:   MarkSamples, MarkSurfaces  1 at pixels whose samples see several surfaces (Screen/SampleEdges.hlsl)
//             ShadePixels                PenumbraMainLightVisibility at all other pixels
//             ShadeSamples               the same filter at the surface of each sample, at marked pixels
//             MeanOfSamples              what of both a target with one sample shows
// Source:     Screen/SampleEdges.hlsl.
// Inputs:     those of ScreenPass.hlsl and Shadows.hlsl, the maps of a filter that reads some; _PenumbraSampleNormals
//             and _PenumbraSampleDepths, of SampleSurfacePass.hlsl or the pipeline; _PenumbraSourceTexture: of
//             MarkSurfaces what MarkSamples found; _PenumbraEdgeTexture: what MarkSurfaces found; _PenumbraPixelTexture
//             and _PenumbraSampleTexture: of the two shading passes; _PenumbraEdgeParameters0, of
//             Screen/Parameters/EdgeParameters.hlsl.
// Cost:       of MarkSamples 2 to 8 fetches; of MarkSurfaces 1, at pixels that MarkSamples found up to 16 more; of the
//             shading passes 1 and those of ResolvePass.hlsl without a mask, ShadeSamples for each sample of marked
//             pixels.
// Guarantees: [0, 1]. A sample that sees the sky is lit.
// Use it:     where lighting is shaded per sample at the same pixels. Not: where each pixel is lit once; then Resolve.
#ifndef PENUMBRA_EDGE_PASSES_HLSL
#define PENUMBRA_EDGE_PASSES_HLSL

// The passes before this one bind the maps that the keyword's filter reads.
#define PENUMBRA_MAPS_BOUND

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Shadows.hlsl"
#include "../ShaderLibrary/Screen/SampleEdges.hlsl"

TEXTURE2D_X_MSAA(float4, _PenumbraSampleNormals);
TEXTURE2D_X_MSAA(float, _PenumbraSampleDepths);
TEXTURE2D_X(_PenumbraEdgeTexture);
TEXTURE2D_X(_PenumbraPixelTexture);
TEXTURE2D_X_MSAA(float, _PenumbraSampleTexture);
float4 _PenumbraEdgeParameters0;

EdgeParameters EdgeParametersOfPass()
{
    EdgeParameters parameters = UnpackEdgeParameters(_PenumbraEdgeParameters0);
    parameters.edgeSamples = min(max(parameters.edgeSamples, 1), kMostSamples);
    return parameters;
}

SampleSurface ReadSampleSurface(ScreenView view, int2 pixel, int samples, int index)
{
    const float2 uv = (float2(pixel) + 0.5 + SampleOffset(samples, index)) * view.size.zw;
    return SurfaceOfSample(view, uv, LOAD_TEXTURE2D_X_MSAA(_PenumbraSampleDepths, pixel, index).x,
                           LOAD_TEXTURE2D_X_MSAA(_PenumbraSampleNormals, pixel, index).xyz);
}

bool IsEdge(int2 pixel)
{
    return LOAD_TEXTURE2D_X(_PenumbraEdgeTexture, pixel).x >= 0.5;
}

float4 MarkSamples(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const EdgeParameters parameters = EdgeParametersOfPass();
    return SamplesDiffer(_PenumbraSampleNormals, int2(input.positionCS.xy), parameters.edgeSamples) ? 1.0 : 0.0;
}

float4 MarkSurfaces(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const int2 pixel = int2(input.positionCS.xy);
    UNITY_BRANCH
    if (LOAD_TEXTURE2D_X(_PenumbraSourceTexture, pixel).x < 0.5) return 0.0;
    const EdgeParameters parameters = EdgeParametersOfPass();
    const ScreenView view = ViewOfThisEye();
    const SampleSurface first = ReadSampleSurface(view, pixel, parameters.edgeSamples, 0);
    UNITY_LOOP
    for (int i = 1; i < parameters.edgeSamples; ++i)
    {
        if (SurfacesDiffer(first, ReadSampleSurface(view, pixel, parameters.edgeSamples, i), parameters)) return 1.0;
    }
    return 0.0;
}

float4 ShadePixels(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const int2 pixel = int2(input.positionCS.xy);
    float visibility = 1.0;
    UNITY_BRANCH
    if (!IsEdge(pixel))
    {
        const CameraSurface surface = ReadCameraSurface(_CameraDepthTexture, ViewOfThisEye(), pixel);
        UNITY_BRANCH
        if (surface.seen)
            visibility = PenumbraMainLightVisibility(surface.positionWS, surface.normalWS, input.positionCS.xy);
    }
    return visibility;
}

float4 ShadeSamples(ScreenVaryings input, uint index : SV_SampleIndex) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const int2 pixel = int2(input.positionCS.xy);
    if (!IsEdge(pixel)) discard;
    const EdgeParameters parameters = EdgeParametersOfPass();
    const SampleSurface surface = ReadSampleSurface(ViewOfThisEye(), pixel, parameters.edgeSamples, int(index));
    if (!surface.seen) return 1.0;
    return PenumbraMainLightVisibility(surface.positionWS, surface.normalWS, float2(pixel) + 0.5);
}

float4 MeanOfSamples(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const int2 pixel = int2(input.positionCS.xy);
    UNITY_BRANCH
    if (!IsEdge(pixel)) return LOAD_TEXTURE2D_X(_PenumbraPixelTexture, pixel).x;
    const int samples = EdgeParametersOfPass().edgeSamples;
    float sum = 0.0;
    UNITY_LOOP
    for (int i = 0; i < samples; ++i) sum += LOAD_TEXTURE2D_X_MSAA(_PenumbraSampleTexture, pixel, i).x;
    return sum / float(samples);
}

#endif
