// Of the test.
// Written by `penumbra emit` from Layers.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_LAYERS_PARAMETERS_HLSL
#define PENUMBRA_LAYERS_PARAMETERS_HLSL

struct LayersParameters
{
    // 1: of one surface
    float opacity;
};

// Unpacks the uniforms _PenumbraLayersParameters0, which the package's C# struct of the same name sets.
LayersParameters UnpackLayersParameters(float4 packed0)
{
    LayersParameters parameters;
    parameters.opacity = packed0.x;
    return parameters;
}

#endif
