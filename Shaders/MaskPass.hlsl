// Penumbra: the penumbra mask of the main light and its dilation.
//
// Computes:   1 where a penumbra may be, else 0, a quarter of the screen's size.
// Source:     Screen/PenumbraMask.hlsl, Screen/MaskBlur.hlsl.
// Inputs:     those of ScreenPass.hlsl and Shadows.hlsl; _PenumbraMaskParameters0, of
//             Screen/Parameters/MaskParameters.hlsl. Target and source: the screen's size over 4, rounded up.
// Cost:       8 fetches per texel of the mask; the dilations 4 depths each and their own.
// Guarantees: exactly 0 or 1, so 8 bits hold it. 0 on the sky.
// Use it:     PenumbraMask, MaskBlurHorizontal, MaskBlurVertical; then Resolve.
#ifndef PENUMBRA_MASK_PASS_HLSL
#define PENUMBRA_MASK_PASS_HLSL

#include "ScreenPass.hlsl"
#include "SingleTap.hlsl"
#include "../ShaderLibrary/Screen/MaskBlur.hlsl"

float4 _PenumbraMaskParameters0;

PenumbraMainLight MainLightAt(CameraSurface surface)
{
    return PreparePenumbraMainLightTap(surface.positionWS, float3(0.0, 0.0, 0.0));
}

float TapVisibility(int2 block, int tap, ScreenView view)
{
    const int2 pixel = MaskTapPixel(block, tap, int2(view.size.xy));
    const CameraSurface surface = ReadCameraPosition(_CameraDepthTexture, view, pixel);
    if (!surface.seen) return 1.0;
    return SingleTap(MainLightAt(surface));
}

float4 PenumbraMask(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const ScreenView view = ViewOfThisEye();
    const int2 block = int2(input.positionCS.xy);
    return MaskOf(float4(TapVisibility(block, 0, view), TapVisibility(block, 1, view),
                         TapVisibility(block, 2, view), TapVisibility(block, 3, view)));
}

// The block's radius is the largest that one of its taps needs.
int RadiusOfBlock(int2 block, ScreenView view)
{
    const MaskParameters parameters = UnpackMaskParameters(_PenumbraMaskParameters0);
    int radius = 0;
    UNITY_UNROLL
    for (int tap = 0; tap < kMaskTaps; ++tap)
    {
        const int2 pixel = MaskTapPixel(block, tap, int2(view.size.xy));
        const CameraSurface surface = ReadCameraPosition(_CameraDepthTexture, view, pixel);
        const PenumbraMainLight shadow = MainLightAt(surface);
        const float reach = MaskReachMetres(shadow.receiver.shadowCoord.z, shadow.tile, parameters);
        const int needed = MaskRadius(reach, surface.metresPerPixel, parameters);
        if (surface.seen && shadow.covered) radius = max(radius, needed);
    }
    return radius;
}

float WidenAlong(float4 positionCS, int2 direction)
{
    const int2 block = int2(positionCS.xy);
    const int radius = RadiusOfBlock(block, ViewOfThisEye());
    return WidenMask(_PenumbraSourceTexture, block, direction, radius, int2(_PenumbraSourceSize.xy));
}

float4 MaskBlurHorizontal(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    return WidenAlong(input.positionCS, int2(1, 0));
}

float4 MaskBlurVertical(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    return WidenAlong(input.positionCS, int2(0, 1));
}

#endif
