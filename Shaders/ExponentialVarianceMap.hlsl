// Penumbra: the exponential variance map.
//
// Computes:   the value of a texel of that map.
// Source:     Map/DepthWarp.hlsl.
// Inputs:     those of MapPasses.hlsl and the exponents.
// Cost:       no fetches of its own.
// Guarantees: finite for any depth.
// Use it:     in the passes of PenumbraMaps.shader. Not: elsewhere.
#ifndef PENUMBRA_EXPONENTIAL_VARIANCE_MAP_HLSL
#define PENUMBRA_EXPONENTIAL_VARIANCE_MAP_HLSL

#include "MapPasses.hlsl"
#include "../ShaderLibrary/Filters/Prefiltered/Parameters/ExponentialVarianceParameters.hlsl"
#include "../ShaderLibrary/Map/DepthWarp.hlsl"

float4 _PenumbraExponentialVarianceParameters0;

float4 MapValue(float storedDepth)
{
    const ExponentialVarianceParameters parameters =
        UnpackExponentialVarianceParameters(_PenumbraExponentialVarianceParameters0);
    const float2 exponents = float2(BoundedOrLow(parameters.positiveExponent, 1.0, kLargestSquaredExponent),
                                    BoundedOrLow(parameters.negativeExponent, 1.0, kLargestSquaredExponent));
    return WarpedMoments(storedDepth, exponents);
}

#include "MapLevels.hlsl"

#endif
