// PCSS: penumbra widths follow from the light's angular diameter.
// Written by `penumbra emit` from ShaderLibrary/Filters/Pcss/PcssAngular.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_PCSS_ANGULAR_PARAMETERS_HLSL
#define PENUMBRA_PCSS_ANGULAR_PARAMETERS_HLSL

struct PcssAngularParameters
{
    // fetches: samples of the blocker search, 1 to 128
    int blockerSamples;
    // fetches: samples of the filter, 1 to 128
    int filterSamples;
    // 1: radial distribution of the search samples: 0 equally many per octave of radius, 1 uniform over the area, 2
    // density 1/r
    float blockerClump;
    // texels: smallest filter and search radius
    float minFilterTexels;
    // m: largest penumbra width, from visibility 0 to 1; caps both radii
    float maxPenumbraMetres;
    // m: height of the light's cone above the receiver, beyond which it is a cylinder
    float maxSamplingMetres;
};

// Unpacks the uniforms _PenumbraPcssAngularParameters0, _PenumbraPcssAngularParameters1, which the package's C# struct
// of the same name sets.
PcssAngularParameters UnpackPcssAngularParameters(float4 packed0, float4 packed1)
{
    PcssAngularParameters parameters;
    parameters.blockerSamples = int(packed0.x);
    parameters.filterSamples = int(packed0.y);
    parameters.blockerClump = packed0.z;
    parameters.minFilterTexels = packed0.w;
    parameters.maxPenumbraMetres = packed1.x;
    parameters.maxSamplingMetres = packed1.y;
    return parameters;
}

#endif
