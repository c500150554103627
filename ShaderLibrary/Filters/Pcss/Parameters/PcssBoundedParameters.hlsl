// PCSS whose search ends where no blocker can be.
// Written by `penumbra emit` from ShaderLibrary/Filters/Pcss/PcssBounded.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_PCSS_BOUNDED_PARAMETERS_HLSL
#define PENUMBRA_PCSS_BOUNDED_PARAMETERS_HLSL

struct PcssBoundedParameters
{
    // fetches: samples of the blocker search, 1 to 128
    int searchSamples;
    // fetches: samples of the filter in penumbrae wider than 4.25 texels, 1 to 128
    int filterSamples;
    // m: largest penumbra width, from visibility 0 to 1
    float maxPenumbraMetres;
};

// Unpacks the uniforms _PenumbraPcssBoundedParameters0, which the package's C# struct of the same name sets.
PcssBoundedParameters UnpackPcssBoundedParameters(float4 packed0)
{
    PcssBoundedParameters parameters;
    parameters.searchSamples = int(packed0.x);
    parameters.filterSamples = int(packed0.y);
    parameters.maxPenumbraMetres = packed0.z;
    return parameters;
}

#endif
