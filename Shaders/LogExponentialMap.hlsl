// Penumbra: the passes of the exponential map in logarithmic space.
//
// Computes:   log(mean of exp(c z)) / c + 1/2 over a separable Gaussian: rows from the shadow map, then columns.
// Source:     Map/LogarithmicSum.hlsl.
// Inputs:     those of MapPasses.hlsl and the exponent.
// Cost:       1 + 2 ceil(2.5 deviation) fetches in each of the two.
// Guarantees: in [0, 1]; between the nearest and the farthest depth of the blurred area.
// Use it:     as passes that run for each cascade. Not: over the screen.
#ifndef PENUMBRA_LOG_EXPONENTIAL_MAP_HLSL
#define PENUMBRA_LOG_EXPONENTIAL_MAP_HLSL

#include "MapPasses.hlsl"
#include "../ShaderLibrary/Filters/Prefiltered/Parameters/LogExponentialParameters.hlsl"
#include "../ShaderLibrary/Map/LogarithmicSum.hlsl"

float4 _PenumbraLogExponentialParameters0;

float LogExponent()
{
    const LogExponentialParameters parameters = UnpackLogExponentialParameters(_PenumbraLogExponentialParameters0);
    return BoundedOrLow(parameters.exponent, 1.0, 1000.0);
}

float4 LogRows(ScreenVaryings input) : SV_Target
{
    const float deviation = MapDeviation();
    const float exponent = LogExponent();
    const int reach = MapBlurReach(deviation);
    LogarithmicSum sum = EmptyLogarithmicSum();
    float weights = 0.0;
    for (int i = -reach; i <= reach; ++i)
    {
        const int2 texel = MapBlurTexel(int2(input.positionCS.xy), int2(i, 0), _PenumbraTile);
        const float weight = MapBlurWeight(i, deviation);
        const float stored = SanitizeMapDepth(LOAD_TEXTURE2D(_MainLightShadowmapTexture, texel).x);
        sum = AddTerm(sum, exponent * CentredDepth(stored), weight);
        weights += weight;
    }
    return float4((LogarithmOf(sum) - log(weights)) / exponent + 0.5, 0.0, 0.0, 0.0);
}

float4 LogColumns(ScreenVaryings input) : SV_Target
{
    const float deviation = MapDeviation();
    const float exponent = LogExponent();
    const int reach = MapBlurReach(deviation);
    LogarithmicSum sum = EmptyLogarithmicSum();
    float weights = 0.0;
    for (int i = -reach; i <= reach; ++i)
    {
        const int2 texel = MapBlurTexel(int2(input.positionCS.xy), int2(0, i), _PenumbraTile);
        const float weight = MapBlurWeight(i, deviation);
        sum = AddTerm(sum, exponent * (LOAD_TEXTURE2D_X(_PenumbraSourceTexture, texel).x - 0.5), weight);
        weights += weight;
    }
    return float4((LogarithmOf(sum) - log(weights)) / exponent + 0.5, 0.0, 0.0, 0.0);
}

#endif
