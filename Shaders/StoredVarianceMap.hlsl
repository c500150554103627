// Penumbra: the variance map in numbers between 0 and 1.
//
// Computes:   the value of a texel of that map.
// Source:     Map/DepthMoments.hlsl.
// Inputs:     those of MapPasses.hlsl.
// Cost:       no fetches of its own.
// Guarantees: [0, 1], for integer formats, whose steps are as fine everywhere.
// Use it:     in the passes of PenumbraMaps.shader. Not: elsewhere.
#ifndef PENUMBRA_STORED_VARIANCE_MAP_HLSL
#define PENUMBRA_STORED_VARIANCE_MAP_HLSL

#include "MapPasses.hlsl"

float4 MapValue(float storedDepth)
{
    return float4(StoredDepthMoments(storedDepth), 0.0, 0.0);
}

#include "MapLevels.hlsl"

#endif
