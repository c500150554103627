// Penumbra: the exponential map.
//
// Computes:   the value of a texel of that map.
// Source:     Map/DepthWarp.hlsl.
// Inputs:     those of MapPasses.hlsl and the exponent.
// Cost:       no fetches of its own.
// Guarantees: finite for any depth.
// Use it:     in the passes of PenumbraMaps.shader. Not: elsewhere.
#ifndef PENUMBRA_EXPONENTIAL_MAP_HLSL
#define PENUMBRA_EXPONENTIAL_MAP_HLSL

#include "MapPasses.hlsl"
#include "../ShaderLibrary/Filters/Prefiltered/Parameters/ExponentialParameters.hlsl"
#include "../ShaderLibrary/Map/DepthWarp.hlsl"

float4 _PenumbraExponentialParameters0;

float4 MapValue(float storedDepth)
{
    const ExponentialParameters parameters = UnpackExponentialParameters(_PenumbraExponentialParameters0);
    const float exponent = BoundedOrLow(parameters.exponent, 1.0, kLargestExponent);
    return float4(ExponentialOfDepth(storedDepth, exponent), 0.0, 0.0, 0.0);
}

#endif
