// PCSS (Godot): with the rules and parameters of Godot 4.
// Written by `penumbra emit` from ShaderLibrary/Filters/Peers/GodotPcss.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_GODOT_PCSS_PARAMETERS_HLSL
#define PENUMBRA_GODOT_PCSS_PARAMETERS_HLSL

struct GodotPcssParameters
{
    // fetches: number of blocker samples and of filter samples, 1 to 64: 4, 8, 12, 24 or 32 by quality
    int samples;
    // 1: angular size of the light, as a share of its diameter
    float diameterShare;
    // 1: by which the receiver moves toward the light, as a share of the depth range
    float depthBias;
    // texels: by which the receiver moves along its normal, across the light alone
    float normalBias;
};

// Unpacks the uniforms _PenumbraGodotPcssParameters0, which the package's C# struct of the same name sets.
GodotPcssParameters UnpackGodotPcssParameters(float4 packed0)
{
    GodotPcssParameters parameters;
    parameters.samples = int(packed0.x);
    parameters.diameterShare = packed0.y;
    parameters.depthBias = packed0.z;
    parameters.normalBias = packed0.w;
    return parameters;
}

#endif
