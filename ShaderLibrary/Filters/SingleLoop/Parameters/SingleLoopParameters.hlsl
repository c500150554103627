// Soft shadows of one loop over the rings of a disc.
// Written by `penumbra emit` from ShaderLibrary/Filters/SingleLoop/SingleLoop.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_SINGLE_LOOP_PARAMETERS_HLSL
#define PENUMBRA_SINGLE_LOOP_PARAMETERS_HLSL

struct SingleLoopParameters
{
    // fetches: taps, one on each ring of the disc, 1 to 32
    int samples;
    // 1: rings of the disc: 1 of equal area, 2 of equal width
    int ringExponent;
    // m: largest radius of the disc, and with it of a penumbra, across the light
    float discRadiusMetres;
    // texels: smallest radius of disc and penumbra
    float minFilterTexels;
    // texels: of the map of nearest and farthest depths that an early exit reads: its radius in cascade 0
    int dilation0;
    // texels: the same in cascade 1
    int dilation1;
    // texels: the same in cascade 2
    int dilation2;
    // texels: the same in cascade 3
    int dilation3;
};

// Unpacks the uniforms _PenumbraSingleLoopParameters0, _PenumbraSingleLoopParameters1, which the package's C# struct of
// the same name sets.
SingleLoopParameters UnpackSingleLoopParameters(float4 packed0, float4 packed1)
{
    SingleLoopParameters parameters;
    parameters.samples = int(packed0.x);
    parameters.ringExponent = int(packed0.y);
    parameters.discRadiusMetres = packed0.z;
    parameters.minFilterTexels = packed0.w;
    parameters.dilation0 = int(packed1.x);
    parameters.dilation1 = int(packed1.y);
    parameters.dilation2 = int(packed1.z);
    parameters.dilation3 = int(packed1.w);
    return parameters;
}

#endif
