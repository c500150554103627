// Variance soft shadow mapping.
// Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/Vssm.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_VSSM_PARAMETERS_HLSL
#define PENUMBRA_VSSM_PARAMETERS_HLSL

struct VssmParameters
{
    // texels: smallest filter and search radius
    float minFilterTexels;
    // m: largest penumbra width, from visibility 0 to 1; caps both radii
    float maxPenumbraMetres;
    // 1: visibility up to which all is dark, which reduces light bleeding
    float bleeding;
    // 1: variance that rounding may leave of a flat surface, of depths in [-1/2, 1/2]
    float smallestVariance;
    // 1: searches for blockers, each within the penumbra that the one before found; the paper has one
    int searches;
};

// Unpacks the uniforms _PenumbraVssmParameters0, _PenumbraVssmParameters1, which the package's C# struct of the same
// name sets.
VssmParameters UnpackVssmParameters(float4 packed0, float4 packed1)
{
    VssmParameters parameters;
    parameters.minFilterTexels = packed0.x;
    parameters.maxPenumbraMetres = packed0.y;
    parameters.bleeding = packed0.z;
    parameters.smallestVariance = packed0.w;
    parameters.searches = int(packed1.x);
    return parameters;
}

#endif
