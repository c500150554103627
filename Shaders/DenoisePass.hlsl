// Penumbra: smoothing of noise in penumbrae, one direction per pass.
//
// Computes:   Screen/EdgeDenoise.hlsl at this pixel.
// Source:     see there.
// Inputs:     those of ScreenPass.hlsl; source: visibility, of the screen's size;
//             _PenumbraDenoiseParameters0, of Screen/Parameters/DenoiseParameters.hlsl.
// Cost:       2 radius + 1 fetches, twice that in penumbrae and up to 4 more.
// Guarantees: [0, 1]; exactly 0 and 1 where the neighbourhood is.
// Use it:     DenoiseHorizontal, then DenoiseVertical, last of all.
#ifndef PENUMBRA_DENOISE_PASS_HLSL
#define PENUMBRA_DENOISE_PASS_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Screen/EdgeDenoise.hlsl"

float4 _PenumbraDenoiseParameters0;

float DenoiseAlong(float4 positionCS, int2 direction)
{
    return DenoiseEdges(_PenumbraSourceTexture, _CameraDepthTexture, ViewOfThisEye(), int2(positionCS.xy), direction,
                        UnpackDenoiseParameters(_PenumbraDenoiseParameters0));
}

float4 DenoiseHorizontal(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    return DenoiseAlong(input.positionCS, int2(1, 0));
}

float4 DenoiseVertical(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    return DenoiseAlong(input.positionCS, int2(0, 1));
}

#endif
