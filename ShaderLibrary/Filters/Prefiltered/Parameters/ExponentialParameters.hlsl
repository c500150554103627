// Exponential shadow maps.
// Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Exponential.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_EXPONENTIAL_PARAMETERS_HLSL
#define PENUMBRA_EXPONENTIAL_PARAMETERS_HLSL

struct ExponentialParameters
{
    // 1: c of exp(c z), for depths z over the range of the map: at most 172 with 32 bits, 19 with 16
    float exponent;
    // 1: visibility up to which all is dark, which reduces light bleeding
    float bleeding;
};

// Unpacks the uniforms _PenumbraExponentialParameters0, which the package's C# struct of the same name sets.
ExponentialParameters UnpackExponentialParameters(float4 packed0)
{
    ExponentialParameters parameters;
    parameters.exponent = packed0.x;
    parameters.bleeding = packed0.y;
    return parameters;
}

#endif
