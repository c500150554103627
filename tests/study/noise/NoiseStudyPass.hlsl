// Penumbra: the main light's visibility at each pixel, by noise of a choice.
//
// Computes:   as Shaders/ResolvePass.hlsl without a mask, with disks that turn by the gradient noise of the package or,
//             with NOISE_MASK, by the spatio-temporal blue-noise mask.
// Source:     Wolfe, Morrical, Akenine-Moller and Ramamoorthi, "Spatiotemporal Blue Noise Masks" (2022), for the mask.
// Inputs:     those of ResolvePass.hlsl; _PenumbraNoiseMaskTexture: slices of 64 x 64 texels below each other, bytes.
// Cost:       that of ResolvePass.hlsl; the mask takes one fetch more.
// Guarantees: [0, 1], 1 on the sky.
// Use it:     to measure noise (Documentation~/screen-passes.md). Not: in a game.
#ifndef PENUMBRA_NOISE_STUDY_PASS_HLSL
#define PENUMBRA_NOISE_STUDY_PASS_HLSL

#include "../../../Shaders/ScreenPass.hlsl"
#include "../../../ShaderLibrary/Shadows.hlsl"

#define MASK_SIDE 64
#define MASK_SLICES 16

TEXTURE2D(_PenumbraNoiseMaskTexture);

// A byte of 0 .. 255 counts as a share of 256, because 255 is not a whole turn.
float MaskNoise(int2 pixel, uint frame)
{
    const int2 texel = (pixel & (MASK_SIDE - 1)) + int2(0, MASK_SIDE * int(frame & (MASK_SLICES - 1)));
    return (255.0 * LOAD_TEXTURE2D(_PenumbraNoiseMaskTexture, texel).x + 0.5) / 256.0;
}

float4 ResolveWithNoise(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const int2 pixel = int2(input.positionCS.xy);
    const CameraSurface surface = ReadCameraSurface(_CameraDepthTexture, ViewOfThisEye(), pixel);
    if (!surface.seen) return 1.0;
    PenumbraMainLight shadow = PreparePenumbraMainLight(surface.positionWS, surface.normalWS, input.positionCS.xy);
    if (!shadow.covered) return 1.0;
#if defined(NOISE_MASK)
    shadow.receiver.rotation = RotationFromNoise(MaskNoise(pixel, uint(max(_PenumbraMainLightParams.z, 0.0))));
#endif
    return ApplyPenumbraStrength(
        FilterByKeyword(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_PenumbraLinearClampCompare),
                        sampler_PenumbraPointClamp, shadow.receiver, shadow.tile, shadow.cascade));
}

#endif
