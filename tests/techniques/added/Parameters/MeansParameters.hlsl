// Of the test.
// Written by `penumbra emit` from Means.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_MEANS_PARAMETERS_HLSL
#define PENUMBRA_MEANS_PARAMETERS_HLSL

struct MeansParameters
{
    // 1: mip level
    int level;
    // 1: of the result
    float scale;
};

// Unpacks the uniforms _PenumbraMeansParameters0, which the package's C# struct of the same name sets.
MeansParameters UnpackMeansParameters(float4 packed0)
{
    MeansParameters parameters;
    parameters.level = int(packed0.x);
    parameters.scale = packed0.y;
    return parameters;
}

#endif
