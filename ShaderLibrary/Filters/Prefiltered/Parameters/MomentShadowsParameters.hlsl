// Moment shadow maps.
// Written by `penumbra emit` from ShaderLibrary/Filters/Prefiltered/MomentShadows.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_MOMENT_SHADOWS_PARAMETERS_HLSL
#define PENUMBRA_MOMENT_SHADOWS_PARAMETERS_HLSL

struct MomentShadowsParameters
{
    // 1: share of a smooth distribution in the moments, against their rounding: 3e-7 with 32 bits, 6e-5 with 16
    float mix;
    // 1: visibility up to which all is dark, which reduces light bleeding
    float bleeding;
};

// Unpacks the uniforms _PenumbraMomentShadowsParameters0, which the package's C# struct of the same name sets.
MomentShadowsParameters UnpackMomentShadowsParameters(float4 packed0)
{
    MomentShadowsParameters parameters;
    parameters.mix = packed0.x;
    parameters.bleeding = packed0.y;
    return parameters;
}

#endif
