// How far the penumbra mask extends beyond the edges that it found.
// Written by `penumbra emit` from ShaderLibrary/Screen/MaskBlur.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_MASK_PARAMETERS_HLSL
#define PENUMBRA_MASK_PARAMETERS_HLSL

struct MaskParameters
{
    // m: largest penumbra width, from visibility 0 to 1, that the mask must cover; 0 for fixed filters
    float maskPenumbraMetres;
    // texels: smallest filter radius that the mask must cover, in texels of the shadow map
    float maskFilterTexels;
    // texels: largest radius of the dilation, in texels of the mask
    int maskLargestRadius;
};

// Unpacks the uniforms _PenumbraMaskParameters0, which the package's C# struct of the same name sets.
MaskParameters UnpackMaskParameters(float4 packed0)
{
    MaskParameters parameters;
    parameters.maskPenumbraMetres = packed0.x;
    parameters.maskFilterTexels = packed0.y;
    parameters.maskLargestRadius = int(packed0.z);
    return parameters;
}

#endif
