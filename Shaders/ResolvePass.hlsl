// Penumbra: the main light's visibility at each pixel of the screen, or at every second one.
//
// Computes:   PenumbraMainLightVisibility where the camera sees a surface. With a mask, what it says, or one
//             comparison, where it says that no penumbra is near. With visibility of every second pixel, what
//             EdgeUpsample.hlsl makes of it, and the filter where that does not tell.
// Source:     Shadows.hlsl; Screen/EdgeUpsample.hlsl; see the technique's file.
// Inputs:     those of ScreenPass.hlsl and Shadows.hlsl; the maps of a filter that reads some. Target: the screen's
//             size, or half of it rounded up.
//             _PenumbraMaskTexture    of MaskPass.hlsl or ConservativeMaskPass.hlsl; where it is absent,
//                                     _PenumbraMaskSize is 0
//             _PenumbraSourceTexture  visibility at half the screen's size, rounded up, of this pass or a technique's
//                                     own; where it is absent, _PenumbraSourceSize is 0
// Cost:       5 fetches of camera depth, up to 9 at edges, and the technique's. With a mask 1 more; where it skips the
//             filter 1 in all, 3 with a comparison. From half resolution 1 to 4, up to 17 in penumbrae, and the
//             technique's where neighbours differ widely.
// Guarantees: [0, 1]; on the sky 1, or what all neighbours have. It includes the shadow strength, but not the distance
//             fade, which receivers apply.
// Use it:     as the pass of every technique that no kernels draw. One program does it all, and what is absent is not
//             read: each keyword more would double what Unity compiles and ships.
#ifndef PENUMBRA_RESOLVE_PASS_HLSL
#define PENUMBRA_RESOLVE_PASS_HLSL

// The passes before this one bind the maps that the keyword's filter reads.
#define PENUMBRA_MAPS_BOUND

#include "ScreenPass.hlsl"
#include "SingleTap.hlsl"
#include "../ShaderLibrary/Screen/EdgeUpsample.hlsl"
#include "../ShaderLibrary/Screen/PenumbraMask.hlsl"

TEXTURE2D_X(_PenumbraMaskTexture);
float4 _PenumbraMaskSize;

// Any negative visibility is one that is not known yet.
static const float kNotKnown = -1.0;

float OutsidePenumbrae(float mask, int2 pixel, ScreenView view)
{
    const float known = MaskedVisibility(mask);
    if (known >= 0.0) return ApplyPenumbraStrength(known);
    const CameraSurface surface = ReadCameraPosition(_CameraDepthTexture, view, pixel);
    if (!surface.seen) return 1.0;
    const PenumbraMainLight shadow = PreparePenumbraMainLightTap(surface.positionWS, surface.normalWS);
    return ApplyPenumbraStrength(SingleTap(shadow));
}

// The visibility that the mask tells, or a negative number where it does not know.
float VisibilityByMask(int2 pixel, ScreenView view)
{
    float visibility = kNotKnown;
    UNITY_BRANCH
    if (_PenumbraMaskSize.x > 0.0)
    {
        const float mask = LOAD_TEXTURE2D_X(_PenumbraMaskTexture, MaskBlockOf(pixel)).x;
        UNITY_BRANCH
        if (MaskSkipsFilter(mask)) visibility = OutsidePenumbrae(mask, pixel, view);
    }
    return visibility;
}

// taps are those of the picture at half resolution, where there is one.
float FilteredVisibility(int2 pixel, float2 position, ScreenView view, bool upsamples, HalfTaps taps)
{
    const CameraSurface surface = ReadCameraSurface(_CameraDepthTexture, view, pixel);
    float visibility = surface.seen ? kNotKnown : 1.0;
    UNITY_BRANCH
    if (surface.seen && upsamples) visibility = UpsampleOverPlane(_CameraDepthTexture, view, surface, taps);
    UNITY_BRANCH
    if (visibility < 0.0) visibility = PenumbraMainLightVisibility(surface.positionWS, surface.normalWS, position);
    return visibility;
}

float4 Resolve(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const ScreenView view = ViewOfThisEye();
    const int2 pixel = ScreenPixel(input.positionCS);
    float visibility = VisibilityByMask(pixel, view);
    const bool upsamples = _PenumbraSourceSize.x > 0.0;
    HalfTaps taps = (HalfTaps)0;
    UNITY_BRANCH
    if (upsamples)
    {
        taps = ReadHalfTaps(_PenumbraSourceTexture, pixel, int2(_PenumbraSourceSize.xy), int2(view.size.xy));
        if (TapsAgree(taps)) visibility = taps.visibility.x;
    }
    UNITY_BRANCH
    if (visibility < 0.0) visibility = FilteredVisibility(pixel, input.positionCS.xy, view, upsamples, taps);
    return visibility;
}

#endif
