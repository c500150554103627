// PCSS (HDRP): with the rules and parameters of Unity's HDRP.
// Written by `penumbra emit` from ShaderLibrary/Filters/Peers/PcssHdrp.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_PCSS_HDRP_PARAMETERS_HLSL
#define PENUMBRA_PCSS_HDRP_PARAMETERS_HLSL

struct PcssHdrpParameters
{
    // fetches: samples of the blocker search, 1 to 64
    int blockerSamples;
    // fetches: samples of the filter, 1 to 64
    int filterSamples;
    // 1: radial distribution of the search samples: 1 uniform over the area, 2 density 1/r, 4 density r^-1.5
    float blockerClump;
    // texels: smallest filter and search radius
    float minFilterTexels;
    // m: caps the distance of blockers at this / (2 tan(a/2)) for a light of angular diameter a
    float maxPenumbraMetres;
    // m: largest depth offset of the cone
    float maxSamplingMetres;
    // 1: tangent of half the blocker search's angular diameter
    float searchTanHalf;
    // 1: tangent of half the angular diameter of the cone below the smallest filter radius
    float minFilterTanHalf;
};

// Unpacks the uniforms _PenumbraPcssHdrpParameters0, _PenumbraPcssHdrpParameters1, which the package's C# struct of the
// same name sets.
PcssHdrpParameters UnpackPcssHdrpParameters(float4 packed0, float4 packed1)
{
    PcssHdrpParameters parameters;
    parameters.blockerSamples = int(packed0.x);
    parameters.filterSamples = int(packed0.y);
    parameters.blockerClump = packed0.z;
    parameters.minFilterTexels = packed0.w;
    parameters.maxPenumbraMetres = packed1.x;
    parameters.maxSamplingMetres = packed1.y;
    parameters.searchTanHalf = packed1.z;
    parameters.minFilterTanHalf = packed1.w;
    return parameters;
}

#endif
