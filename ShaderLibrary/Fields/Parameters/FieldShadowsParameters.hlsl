// Shadows of objects from their distance fields.
// Written by `penumbra emit` from ShaderLibrary/Fields/FieldShadows.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_FIELD_SHADOWS_PARAMETERS_HLSL
#define PENUMBRA_FIELD_SHADOWS_PARAMETERS_HLSL

struct FieldShadowsParameters
{
    // fetches: steps along each ray or cone through an object's box, 1 to 256
    int fieldSteps;
    // m: objects farther from the receiver than this cast nothing
    float fieldFarthestMetres;
};

// Unpacks the uniforms _PenumbraFieldShadowsParameters0, which the package's C# struct of the same name sets.
FieldShadowsParameters UnpackFieldShadowsParameters(float4 packed0)
{
    FieldShadowsParameters parameters;
    parameters.fieldSteps = int(packed0.x);
    parameters.fieldFarthestMetres = packed0.y;
    return parameters;
}

#endif
