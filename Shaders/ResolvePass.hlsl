// Penumbra: the main light's visibility at each pixel of the screen, or at every second one.
//
// Computes:   PenumbraMainLightVisibility where the camera sees a surface.
// Source:     Shadows.hlsl; the technique's file names its own.
// Inputs:     those of ScreenPass.hlsl and Shadows.hlsl. Target: the screen's size, or half of it rounded up.
// Cost:       5 fetches of camera depth, and the technique's; 1 where the sky is seen.
// Guarantees: [0, 1], 1 on the sky. The shadow strength is in it, the distance fade is not: receivers add that.
// Use it:     as the one pass that every preset has.
#ifndef PENUMBRA_RESOLVE_PASS_HLSL
#define PENUMBRA_RESOLVE_PASS_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Shadows.hlsl"

float4 Resolve(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const int2 pixel = ScreenPixel(input.positionCS);
    const CameraSurface surface = ReadCameraSurface(_CameraDepthTexture, ViewOfThisEye(), pixel);
    if (!surface.seen) return 1.0;
    return PenumbraMainLightVisibility(surface.positionWS, surface.normalWS, input.positionCS.xy);
}

#endif
