// PCSS (Poisson): as many blocker samples as filter samples, on Poisson disks.
// Written by `penumbra emit` from ShaderLibrary/Filters/Pcss/PcssClassic.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_PCSS_CLASSIC_PARAMETERS_HLSL
#define PENUMBRA_PCSS_CLASSIC_PARAMETERS_HLSL

struct PcssClassicParameters
{
    // fetches: number of blocker samples and of filter samples: 25, 32, 64, 100 or 128
    int samples;
    // m: radius of the blocker search, across the light
    float searchRadiusMetres;
    // texels: smallest filter radius
    float minFilterTexels;
};

// Unpacks the uniforms _PenumbraPcssClassicParameters0, which the package's C# struct of the same name sets.
PcssClassicParameters UnpackPcssClassicParameters(float4 packed0)
{
    PcssClassicParameters parameters;
    parameters.samples = int(packed0.x);
    parameters.searchRadiusMetres = packed0.y;
    parameters.minFilterTexels = packed0.z;
    return parameters;
}

#endif
