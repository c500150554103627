// Penumbra: half-resolution visibility upsampled to the screen's resolution, with the filter itself where it must be.
//
// Computes:   Screen/EdgeUpsample.hlsl at this pixel; where that does not tell, PenumbraMainLightVisibility.
// Source:     see there, and Shadows.hlsl.
// Inputs:     those of ScreenPass.hlsl and Shadows.hlsl, the maps of a filter that reads some; source: what Resolve or a
//             technique's own passes wrote at half size, rounded up.
// Cost:       1 to 4 fetches, up to 17 in penumbrae, and the technique's where neighbours differ widely.
// Guarantees: [0, 1]; on the sky 1, or what all neighbours have.
// Use it:     after Resolve, when its target is half the screen.
#ifndef PENUMBRA_UPSAMPLE_PASS_HLSL
#define PENUMBRA_UPSAMPLE_PASS_HLSL

// The passes before this one bind the maps that the keyword's filter reads.
#define PENUMBRA_MAPS_BOUND

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Shadows.hlsl"
#include "../ShaderLibrary/Screen/EdgeUpsample.hlsl"

float4 Upsample(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const ScreenView view = ViewOfThisEye();
    const int2 pixel = int2(input.positionCS.xy);
    const HalfTaps taps = ReadHalfTaps(_PenumbraSourceTexture, pixel, int2(_PenumbraSourceSize.xy), int2(view.size.xy));
    if (TapsAgree(taps)) return taps.visibility.x;
    const CameraSurface here = ReadCameraSurface(_CameraDepthTexture, view, pixel);
    if (!here.seen) return 1.0;
    const float upsampled = UpsampleOverPlane(_CameraDepthTexture, view, here, taps);
    UNITY_BRANCH
    if (upsampled >= 0.0) return upsampled;
    return PenumbraMainLightVisibility(here.positionWS, here.normalWS, input.positionCS.xy);
}

#endif
