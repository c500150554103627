// Penumbra: half-resolution visibility upsampled to the screen's resolution.
//
// Computes:   Screen/EdgeUpsample.hlsl at this pixel.
// Source:     see there.
// Inputs:     those of ScreenPass.hlsl; source: what Resolve wrote at half size, rounded up.
// Cost:       1 to 4 fetches, up to 17 in penumbrae.
// Guarantees: [0, 1].
// Use it:     after Resolve, when its target is half the screen.
#ifndef PENUMBRA_UPSAMPLE_PASS_HLSL
#define PENUMBRA_UPSAMPLE_PASS_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Screen/EdgeUpsample.hlsl"

float4 Upsample(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    return UpsampleEdges(_PenumbraSourceTexture, _CameraDepthTexture, ViewOfThisEye(), int2(input.positionCS.xy),
                         int2(_PenumbraSourceSize.xy));
}

#endif
