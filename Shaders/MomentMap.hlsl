// Penumbra: the map of four moments.
//
// Computes:   the value of a texel of that map.
// Source:     Map/FourMoments.hlsl.
// Inputs:     those of MapPasses.hlsl.
// Cost:       no fetches of its own.
// Guarantees: finite for any depth.
// Use it:     in the passes of PenumbraMaps.shader. Not: elsewhere.
#ifndef PENUMBRA_MOMENT_MAP_HLSL
#define PENUMBRA_MOMENT_MAP_HLSL

#include "MapPasses.hlsl"
#include "../ShaderLibrary/Map/FourMoments.hlsl"

float4 MapValue(float storedDepth)
{
    return StoredMoments(storedDepth);
}

#include "MapLevels.hlsl"

#endif
