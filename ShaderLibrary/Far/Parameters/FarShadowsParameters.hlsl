// Shadows beyond the cascades, and how the cascades are handed over to them.
// Written by `penumbra emit` from ShaderLibrary/Far/FarShadows.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_FAR_SHADOWS_PARAMETERS_HLSL
#define PENUMBRA_FAR_SHADOWS_PARAMETERS_HLSL

struct FarShadowsParameters
{
    // 1: share of the shadow distance, before its end, over which far shadows take over
    float handOverBorder;
    // fetches: steps of a ray over the ground's heights, 1 to 256
    int heightSteps;
    // m: how far from the receiver that ray begins
    float nearestMetres;
};

// Unpacks the uniforms _PenumbraFarShadowsParameters0, which the package's C# struct of the same name sets.
FarShadowsParameters UnpackFarShadowsParameters(float4 packed0)
{
    FarShadowsParameters parameters;
    parameters.handOverBorder = packed0.x;
    parameters.heightSteps = int(packed0.y);
    parameters.nearestMetres = packed0.z;
    return parameters;
}

#endif
