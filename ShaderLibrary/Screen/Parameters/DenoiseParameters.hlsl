// Smoothing of visibility in penumbrae.
// Written by `penumbra emit` from ShaderLibrary/Screen/EdgeDenoise.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_DENOISE_PARAMETERS_HLSL
#define PENUMBRA_DENOISE_PARAMETERS_HLSL

struct DenoiseParameters
{
    // pixels: radius of the neighbourhood, 0 to 8
    int denoiseRadius;
    // pixels: plane distance threshold, in pixel footprints: a neighbour farther away counts as another surface
    float planeTolerance;
    // 1: bilateral range threshold: a larger difference of visibility counts as an edge, not as noise
    float noiseAmplitude;
};

// Unpacks the uniforms _PenumbraDenoiseParameters0, which the package's C# struct of the same name sets.
DenoiseParameters UnpackDenoiseParameters(float4 packed0)
{
    DenoiseParameters parameters;
    parameters.denoiseRadius = int(packed0.x);
    parameters.planeTolerance = packed0.y;
    parameters.noiseAmplitude = packed0.z;
    return parameters;
}

#endif
