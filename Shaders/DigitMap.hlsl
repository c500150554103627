// Penumbra: moments of depth as integers, for summed-area tables.
//
// Computes:   the texels of such a map.
// Source:     Map/DepthDigits.hlsl.
// Inputs:     _MainLightShadowmapTexture, of the target's size.
// Cost:       1 fetch.
// Guarantees: finite for any depth.
// Use it:     in the passes of PenumbraMaps.shader. Not: elsewhere.
#ifndef PENUMBRA_DIGIT_MAP_HLSL
#define PENUMBRA_DIGIT_MAP_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Map/DepthDigits.hlsl"
#include "../ShaderLibrary/Pipelines/Urp.hlsl"

uint4 DepthDigitTexel(ScreenVaryings input) : SV_Target
{
    return DepthDigits(LOAD_TEXTURE2D(_MainLightShadowmapTexture, int2(input.positionCS.xy)).x);
}

uint4 MomentDigitTexel(ScreenVaryings input) : SV_Target
{
    return MomentDigits(LOAD_TEXTURE2D(_MainLightShadowmapTexture, int2(input.positionCS.xy)).x);
}

#endif
