// Moment soft shadow mapping.
// Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Mssm.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_MSSM_PARAMETERS_HLSL
#define PENUMBRA_MSSM_PARAMETERS_HLSL

struct MssmParameters
{
    // texels: smallest filter and search radius
    float minFilterTexels;
    // m: largest penumbra width, from visibility 0 to 1; caps both radii
    float maxPenumbraMetres;
    // 1: visibility up to which all is dark, which reduces light bleeding
    float bleeding;
    // 1: share of a smooth distribution in the moments, against their rounding
    float mix;
    // 1: searches for blockers, each within the penumbra that the one before found; the paper has one
    int searches;
};

// Unpacks the uniforms _PenumbraMssmParameters0, _PenumbraMssmParameters1, which the package's C# struct of the same
// name sets.
MssmParameters UnpackMssmParameters(float4 packed0, float4 packed1)
{
    MssmParameters parameters;
    parameters.minFilterTexels = packed0.x;
    parameters.maxPenumbraMetres = packed0.y;
    parameters.bleeding = packed0.z;
    parameters.mix = packed0.w;
    parameters.searches = int(packed1.x);
    return parameters;
}

#endif
