// Radii of the map of nearest and farthest depths around each texel.
// Written by `penumbra emit` from ShaderLibrary/Filters/SingleLoop/SingleLoop.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_DEPTH_RANGE_PARAMETERS_HLSL
#define PENUMBRA_DEPTH_RANGE_PARAMETERS_HLSL

struct DepthRangeParameters
{
    // texels: radius in cascade 0, in texels of the quarter-resolution map: 8 are 32 texels of the shadow map
    int dilation0;
    // texels: the same in cascade 1
    int dilation1;
    // texels: the same in cascade 2
    int dilation2;
    // texels: the same in cascade 3
    int dilation3;
};

// Unpacks the uniforms _PenumbraDepthRangeParameters0, which the package's C# struct of the same name sets.
DepthRangeParameters UnpackDepthRangeParameters(float4 packed0)
{
    DepthRangeParameters parameters;
    parameters.dilation0 = int(packed0.x);
    parameters.dilation1 = int(packed0.y);
    parameters.dilation2 = int(packed0.z);
    parameters.dilation3 = int(packed0.w);
    return parameters;
}

#endif
