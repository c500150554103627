// Kernel of N x N bilinear comparisons with equal weights.
// Written by `penumbra emit` from ShaderLibrary/Filters/Fixed/FixedPcf.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_BOX_PARAMETERS_HLSL
#define PENUMBRA_BOX_PARAMETERS_HLSL

struct BoxParameters
{
    // taps: N, odd, 1 to 9
    int tapsPerSide;
};

// Unpacks the uniforms _PenumbraBoxParameters0, which the package's C# struct of the same name sets.
BoxParameters UnpackBoxParameters(float4 packed0)
{
    BoxParameters parameters;
    parameters.tapsPerSide = int(packed0.x);
    return parameters;
}

#endif
