// Shadows beyond the cascades, and how the cascades are handed over to them.
// Written by `penumbra emit` from ShaderLibrary/Far/FarShadows.technique.json; do not edit.
//
// Each comment gives the field's unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_FAR_SHADOWS_PARAMETERS_HLSL
#define PENUMBRA_FAR_SHADOWS_PARAMETERS_HLSL

struct FarShadowsParameters
{
    float handOverBorder; // 1: share of the shadow distance, before its end, over which far shadows take over
    int heightSteps; // fetches: steps of a ray over the ground's heights, 1 to 256
    float nearestMetres; // m: how far from the receiver that ray begins
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
