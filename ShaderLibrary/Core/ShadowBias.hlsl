// Penumbra: biases against surfaces that shadow themselves (shadow acne).
//
// Computes:   URP's caster bias, slope-scaled bias, and a bias that adapts to slope and kernel together.
// Source:     caster bias: URP's depth and normal bias, both proportional to the texel and the soft kernel's radius.
//             Slope-scaled: Direct3D's depth-bias rule. Adaptive: Dou et al., "Adaptive Depth Bias for Shadow
//             Maps", I3D 2014, reduced to the plane of Isidoro, GDC 2006: the largest depth the receiver's plane
//             reaches above the pixel within the kernel's footprint.
// Inputs:     metres and world space for casters; stored depth and texels for receivers.
// Cost:       no fetches.
// Guarantees: receiver biases are >= 0, finite, and not above the bound the caller gives.
// Use it:     caster bias when drawing the map; adaptive bias where a tap cannot have a reference depth of its own;
//             the receiver plane itself (ReceiverPlane.hlsl) where it can.
#ifndef PENUMBRA_SHADOW_BIAS_HLSL
#define PENUMBRA_SHADOW_BIAS_HLSL

#include "FloatBits.hlsl"

// URP's pair (depth bias, normal bias) in metres, both <= 0. settings: URP's unitless depth and normal bias.
// kernelRadiusTexels: 1 for hard shadows, 2.5 (or by quality) for soft ones.
float2 CasterBiasMetres(float2 settings, float texelSizeMetres, float kernelRadiusTexels)
{
    return -settings * texelSizeMetres * kernelRadiusTexels;
}

// A caster's vertex moved away from the light and into the object. towardLightWS: unit, from surface to light.
float3 BiasCaster(float3 positionWS, float3 normalWS, float3 towardLightWS, float2 biasMetres)
{
    const float cosine = min(max(dot(towardLightWS, normalWS), 0.0), 1.0);
    return positionWS + towardLightWS * biasMetres.x + normalWS * ((1.0 - cosine) * biasMetres.y);
}

// Stored depth by which to move a receiver toward the light: constant part plus slope. cosine: of the angle between
// normal and light. No technique calls it; it is for the option of a bias by the normal's slope.
float SlopeScaledBias(float constantBias, float slopeBias, float cosine, float largestBias)
{
    const float c = min(max(cosine, 1e-3), 1.0);
    const float slope = sqrt(max(1.0 - c * c, 0.0)) / c;
    return BoundedOrLow(constantBias + slopeBias * slope, 0.0, largestBias);
}

// Stored depth by which the receiver's plane rises above the pixel anywhere within a square kernel of half-width
// `radius` (atlas UV, per axis).
float AdaptiveBias(float2 gradient, float2 radius, float largestBias)
{
    return BoundedOrLow(dot(abs(gradient), radius), 0.0, largestBias);
}

#endif
