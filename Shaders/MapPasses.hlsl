// Penumbra: the passes that make maps which may be filtered.
//
// Computes:   values of depth, blurred by a separable Gaussian: rows from the shadow map itself, then columns.
// Source:     Map/MapBlur.hlsl.
// Inputs:     _MainLightShadowmapTexture  the shadow map, of the target's size
//             _PenumbraSourceTexture      of the columns: the rows
//             _PenumbraTile               the cascade's tile in the target: x, y, width, height in texels
//             MapValue                    a function of the including file: the value that a depth becomes
// Cost:       1 + 2 ceil(2.5 deviation) fetches in each of the two.
// Guarantees: nothing outside of the tile is read.
// Use it:     as passes that run for each cascade. Not: over the screen.
#ifndef PENUMBRA_MAP_PASSES_HLSL
#define PENUMBRA_MAP_PASSES_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Filters/Prefiltered/Parameters/MapBlurParameters.hlsl"
#include "../ShaderLibrary/Map/DepthMoments.hlsl"
#include "../ShaderLibrary/Map/MapBlur.hlsl"
#include "../ShaderLibrary/Pipelines/Urp.hlsl"

float4 _PenumbraTile;
float4 _PenumbraMapBlurParameters0;

float4 MapValue(float storedDepth);

float MapDeviation()
{
    const MapBlurParameters parameters = UnpackMapBlurParameters(_PenumbraMapBlurParameters0);
    return BoundedOrLow(parameters.deviation, 0.0, kLargestMapDeviation);
}

float4 MapRows(ScreenVaryings input) : SV_Target
{
    const float deviation = MapDeviation();
    const int reach = MapBlurReach(deviation);
    float4 sum = float4(0.0, 0.0, 0.0, 0.0);
    float weights = 0.0;
    for (int i = -reach; i <= reach; ++i)
    {
        const int2 texel = MapBlurTexel(int2(input.positionCS.xy), int2(i, 0), _PenumbraTile);
        const float weight = MapBlurWeight(i, deviation);
        sum += weight * MapValue(LOAD_TEXTURE2D(_MainLightShadowmapTexture, texel).x);
        weights += weight;
    }
    return sum / weights;
}

float4 MapColumns(ScreenVaryings input) : SV_Target
{
    const float deviation = MapDeviation();
    const int reach = MapBlurReach(deviation);
    float4 sum = float4(0.0, 0.0, 0.0, 0.0);
    float weights = 0.0;
    for (int i = -reach; i <= reach; ++i)
    {
        const int2 texel = MapBlurTexel(int2(input.positionCS.xy), int2(0, i), _PenumbraTile);
        const float weight = MapBlurWeight(i, deviation);
        sum += weight * LOAD_TEXTURE2D_X(_PenumbraSourceTexture, texel);
        weights += weight;
    }
    return sum / weights;
}

#endif
