// Of the test.
// Written by `penumbra emit` from Means.technique.json; do not edit.
//
// Each comment gives the field's unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_MEANS_PARAMETERS_HLSL
#define PENUMBRA_MEANS_PARAMETERS_HLSL

struct MeansParameters
{
    int level; // 1: mip level
    float scale; // 1: of the result
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
