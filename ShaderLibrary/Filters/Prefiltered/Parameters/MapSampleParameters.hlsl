// Samples of a multisampled shadow map.
// Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/VarianceMultisampled.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_MAP_SAMPLE_PARAMETERS_HLSL
#define PENUMBRA_MAP_SAMPLE_PARAMETERS_HLSL

struct MapSampleParameters
{
    // 1: samples of a texel: 2, 4 or 8
    int mapSamples;
};

// Unpacks the uniforms _PenumbraMapSampleParameters0, which the package's C# struct of the same name sets.
MapSampleParameters UnpackMapSampleParameters(float4 packed0)
{
    MapSampleParameters parameters;
    parameters.mapSamples = int(packed0.x);
    return parameters;
}

#endif
