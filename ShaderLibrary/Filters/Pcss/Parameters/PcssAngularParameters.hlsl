// PCSS: penumbra widths follow from the light's angular diameter.
// Written by `penumbra emit` from ShaderLibrary/Filters/Pcss/PcssAngular.technique.json; do not edit.
//
// Each comment gives the field's unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_PCSS_ANGULAR_PARAMETERS_HLSL
#define PENUMBRA_PCSS_ANGULAR_PARAMETERS_HLSL

struct PcssAngularParameters
{
    int blockerSamples; // fetches: samples of the blocker search, 1 to 64
    int filterSamples; // fetches: samples of the filter, 1 to 64
    float blockerClump; // 1: radial distribution of the search samples: 0 equally many per octave of radius, 1 uniform over the area, 2 density 1/r
    float minFilterTexels; // texels: smallest filter and search radius
    float maxPenumbraMetres; // m: largest penumbra width, from visibility 0 to 1; caps both radii
    float maxSamplingMetres; // m: height of the light's cone above the receiver, beyond which it is a cylinder
};

// Unpacks the uniforms _PenumbraPcssAngularParameters0, _PenumbraPcssAngularParameters1, which the package's C# struct of the same name sets.
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
