// Exponential variance shadow maps.
// Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/ExponentialVariance.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_EXPONENTIAL_VARIANCE_PARAMETERS_HLSL
#define PENUMBRA_EXPONENTIAL_VARIANCE_PARAMETERS_HLSL

struct ExponentialVarianceParameters
{
    // 1: c of exp(c z), for depths z over the range of the map: at most 86 with 32 bits, 9 with 16
    float positiveExponent;
    // 1: d of -exp(-d z), with the same limits
    float negativeExponent;
    // 1: visibility up to which all is dark, which reduces light bleeding
    float bleeding;
    // 1: unit roundoff of the map's format: 2^-24 with 32 bits, 2^-11 with 16
    float precision;
};

// Unpacks the uniforms _PenumbraExponentialVarianceParameters0, which the package's C# struct of the same name sets.
ExponentialVarianceParameters UnpackExponentialVarianceParameters(float4 packed0)
{
    ExponentialVarianceParameters parameters;
    parameters.positiveExponent = packed0.x;
    parameters.negativeExponent = packed0.y;
    parameters.bleeding = packed0.z;
    parameters.precision = packed0.w;
    return parameters;
}

#endif
