// PCSS of a spot light: penumbra widths follow from the radius of its source.
// Written by `penumbra emit` from ShaderLibrary/Filters/Pcss/PcssSpot.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_PCSS_SPOT_PARAMETERS_HLSL
#define PENUMBRA_PCSS_SPOT_PARAMETERS_HLSL

struct PcssSpotParameters
{
    // fetches: samples of the blocker search, 1 to 64
    int blockerSamples;
    // fetches: samples of the filter, 1 to 64
    int filterSamples;
    // texels: smallest filter and search radius
    float minFilterTexels;
    // m: largest penumbra width, from visibility 0 to 1; caps both radii
    float maxPenumbraMetres;
};

// Unpacks the uniforms _PenumbraPcssSpotParameters0, which the package's C# struct of the same name sets.
PcssSpotParameters UnpackPcssSpotParameters(float4 packed0)
{
    PcssSpotParameters parameters;
    parameters.blockerSamples = int(packed0.x);
    parameters.filterSamples = int(packed0.y);
    parameters.minFilterTexels = packed0.z;
    parameters.maxPenumbraMetres = packed0.w;
    return parameters;
}

#endif
