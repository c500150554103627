// Variance shadow maps.
// Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Variance.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_VARIANCE_PARAMETERS_HLSL
#define PENUMBRA_VARIANCE_PARAMETERS_HLSL

struct VarianceParameters
{
    // 1: visibility up to which all is dark, which reduces light bleeding
    float bleeding;
    // 1: unit roundoff of the map's format: 2^-24 with 32 bits, 2^-11 with 16
    float precision;
};

// Unpacks the uniforms _PenumbraVarianceParameters0, which the package's C# struct of the same name sets.
VarianceParameters UnpackVarianceParameters(float4 packed0)
{
    VarianceParameters parameters;
    parameters.bleeding = packed0.x;
    parameters.precision = packed0.y;
    return parameters;
}

#endif
