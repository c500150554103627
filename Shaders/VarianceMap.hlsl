// Penumbra: the variance map.
//
// Computes:   the value of a texel of that map.
// Source:     Map/DepthMoments.hlsl.
// Inputs:     those of MapPasses.hlsl.
// Cost:       no fetches of its own.
// Guarantees: finite for any depth.
// Use it:     in the passes of PenumbraMaps.shader. Not: elsewhere.
#ifndef PENUMBRA_VARIANCE_MAP_HLSL
#define PENUMBRA_VARIANCE_MAP_HLSL

#include "MapPasses.hlsl"

float4 MapValue(float storedDepth)
{
    return float4(DepthMoments(storedDepth), 0.0, 0.0);
}

#endif
