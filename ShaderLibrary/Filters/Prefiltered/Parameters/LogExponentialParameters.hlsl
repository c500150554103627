// Exponential shadow maps in logarithmic space.
// Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/LogExponential.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_LOG_EXPONENTIAL_PARAMETERS_HLSL
#define PENUMBRA_LOG_EXPONENTIAL_PARAMETERS_HLSL

struct LogExponentialParameters
{
    // 1: c of exp(c z), for depths z over the range of the map
    float exponent;
    // 1: visibility up to which all is dark, which reduces light bleeding
    float bleeding;
};

// Unpacks the uniforms _PenumbraLogExponentialParameters0, which the package's C# struct of the same name sets.
LogExponentialParameters UnpackLogExponentialParameters(float4 packed0)
{
    LogExponentialParameters parameters;
    parameters.exponent = packed0.x;
    parameters.bleeding = packed0.y;
    return parameters;
}

#endif
