// Penumbra: the common part of all screen passes.
//
// Computes:   a triangle that covers the target, and the ScreenView of the eye being drawn.
// Source:     one triangle with corners (-1, -1), (3, -1), (-1, 3) in clip space.
// Inputs:     _PenumbraScreenToWorld   per eye: (uv, stored camera depth, 1) to homogeneous world position
//             _PenumbraScreenSize      of the screen, full resolution: width, height, 1 / width, 1 / height
//             _PenumbraTargetSize      of the pass's target, the same
//             _PenumbraSourceSize      of _PenumbraSourceTexture, the same
//             _PenumbraSourceTexture   the output of the previous pass
// Cost:       no fetches.
// Guarantees: pixels are identified by SV_Position, so no pass depends on where the target's first row is. Each eye of
//             a stereo target reads its own slice and matrix.
// Use it:     with a procedural draw of 3 vertices. Not: in shaders of objects.
#ifndef PENUMBRA_SCREEN_PASS_HLSL
#define PENUMBRA_SCREEN_PASS_HLSL

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"
#include "../ShaderLibrary/Core/ScreenScale.hlsl"
#include "../ShaderLibrary/Screen/CameraSurface.hlsl"

float4x4 _PenumbraScreenToWorld[2];
float4 _PenumbraScreenSize;
float4 _PenumbraTargetSize;
float4 _PenumbraSourceSize;

TEXTURE2D_X(_PenumbraSourceTexture);

struct ScreenAttributes
{
    uint vertexID : SV_VertexID;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct ScreenVaryings
{
    float4 positionCS : SV_POSITION;
    UNITY_VERTEX_OUTPUT_STEREO
};

ScreenVaryings ScreenTriangle(ScreenAttributes input)
{
    ScreenVaryings output;
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output);
    const float2 corner = float2((input.vertexID << 1) & 2, input.vertexID & 2);
    output.positionCS = float4(2.0 * corner - 1.0, 0.5, 1.0);
    return output;
}

ScreenView ViewOfThisEye()
{
    ScreenView view;
    view.screenToWorld = _PenumbraScreenToWorld[SLICE_ARRAY_INDEX];
    view.size = _PenumbraScreenSize;
    return view;
}

// The pixel of the screen that corresponds to this pixel of the target.
int2 ScreenPixel(float4 positionCS)
{
    const int scale = ScreenScale(_PenumbraScreenSize.x, _PenumbraTargetSize.x);
    return FullPixel(int2(positionCS.xy), scale, int2(_PenumbraScreenSize.xy));
}

#endif
