// Penumbra: the shadows of balls that stand for objects, over the screen.
//
// Computes:   Blobs: the product of BlobVisibility over the balls, where the camera sees a surface
// Source:     Core/BlobShadow.hlsl.
// Inputs:     _PenumbraBalls: centre and radius of each, metres; _PenumbraBallCount: how many of the 16 there are;
//             _PenumbraTowardSun: direction towards the sun, unit, and half its angular diameter in radians; those of
//             ScreenPass.hlsl; _PenumbraBlobParameters0, of BlobParameters.hlsl.
// Cost:       5 fetches of camera depth, up to 9 at edges; arithmetic for each ball above.
// Guarantees: [0, 1], 1 on the sky.
// Use it:     for the few largest objects far away. Not: without a limit to their number.
#ifndef PENUMBRA_BLOB_PASS_HLSL
#define PENUMBRA_BLOB_PASS_HLSL

#include "ScreenPass.hlsl"
#include "Parameters/BlobParameters.hlsl"
#include "../ShaderLibrary/Core/BlobShadow.hlsl"

static const int kMostBalls = 16;

float4 _PenumbraBalls[16];
int _PenumbraBallCount;
float4 _PenumbraTowardSun;
float4 _PenumbraBlobParameters0;

float4 Blobs(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const CameraSurface surface = ReadCameraSurface(_CameraDepthTexture, ViewOfThisEye(),
                                                    ScreenPixel(input.positionCS));
    if (!surface.seen) return 1.0;
    const BlobParameters parameters = UnpackBlobParameters(_PenumbraBlobParameters0);
    const int count = min(max(_PenumbraBallCount, 0), kMostBalls);
    float visibility = 1.0;
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        visibility *= BlobVisibility(surface.positionWS, surface.normalWS, _PenumbraBalls[i], _PenumbraTowardSun,
                                     parameters.blobFadeMetres);
    }
    return visibility;
}

#endif
