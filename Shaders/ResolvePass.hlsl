// Penumbra: the main light's visibility at each pixel of the screen, or at every second one.
//
// Computes:   PenumbraMainLightVisibility where the camera sees a surface; with _PENUMBRA_MASK what the mask says, or one
//             comparison, where it says that no penumbra is near.
// Source:     Shadows.hlsl; see the technique's file.
// Inputs:     those of ScreenPass.hlsl and Shadows.hlsl; _PenumbraMaskTexture: of MaskPass.hlsl or
//             ConservativeMaskPass.hlsl; the maps of a filter that reads some, or of exits with _PENUMBRA_EXITS, of
//             PenumbraMaps.shader. Target: the screen's size, or half of it rounded up.
// Cost:       5 fetches of camera depth, up to 9 at edges, and the technique's. With a mask 1 more; where it skips the
//             filter 1 in all, 3 with a comparison. With exits up to 18 more, and none of the technique's where they decide.
// Guarantees: [0, 1], 1 on the sky. It includes the shadow strength, but not the distance fade, which receivers apply.
// Use it:     as the pass of every technique that no kernels draw.
#ifndef PENUMBRA_RESOLVE_PASS_HLSL
#define PENUMBRA_RESOLVE_PASS_HLSL

// The passes before this one bind the maps that the keyword's filter reads.
#define PENUMBRA_MAPS_BOUND

#include "ScreenPass.hlsl"
#include "SingleTap.hlsl"
#include "../ShaderLibrary/Screen/PenumbraMask.hlsl"

#if defined(PENUMBRA_USES_EXITS)
// Unity's compiler sees that a filter without a search leaves the loop of FilterExits.hlsl in its first turn; one with a search
// needs the loop kept as it is.
#pragma warning(disable : 3557)
#endif

TEXTURE2D_X(_PenumbraMaskTexture);

float OutsidePenumbrae(float mask, int2 pixel, ScreenView view)
{
    const float known = MaskedVisibility(mask);
    if (known >= 0.0) return ApplyPenumbraStrength(known);
    const CameraSurface surface = ReadCameraPosition(_CameraDepthTexture, view, pixel);
    if (!surface.seen) return 1.0;
    const PenumbraMainLight shadow = PreparePenumbraMainLightTap(surface.positionWS, surface.normalWS);
    return ApplyPenumbraStrength(SingleTap(shadow));
}

float4 Resolve(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const ScreenView view = ViewOfThisEye();
    const int2 pixel = ScreenPixel(input.positionCS);
#if defined(_PENUMBRA_MASK)
    const float mask = LOAD_TEXTURE2D_X(_PenumbraMaskTexture, MaskBlockOf(pixel)).x;
    UNITY_BRANCH
    if (MaskSkipsFilter(mask)) return OutsidePenumbrae(mask, pixel, view);
#endif
    const CameraSurface surface = ReadCameraSurface(_CameraDepthTexture, view, pixel);
    if (!surface.seen) return 1.0;
    return PenumbraMainLightVisibility(surface.positionWS, surface.normalWS, input.positionCS.xy);
}

#endif
