// Blur of a filtered shadow map.
// Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Variance.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_MAP_BLUR_PARAMETERS_HLSL
#define PENUMBRA_MAP_BLUR_PARAMETERS_HLSL

struct MapBlurParameters
{
    // texels: standard deviation of the Gaussian
    float deviation;
};

// Unpacks the uniforms _PenumbraMapBlurParameters0, which the package's C# struct of the same name sets.
MapBlurParameters UnpackMapBlurParameters(float4 packed0)
{
    MapBlurParameters parameters;
    parameters.deviation = packed0.x;
    return parameters;
}

#endif
