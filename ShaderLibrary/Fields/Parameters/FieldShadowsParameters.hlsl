// Shadows of objects from their distance fields.
// Written by `penumbra emit` from ShaderLibrary/Fields/FieldShadows.technique.json; do not edit.
//
// Each comment gives the field's unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_FIELD_SHADOWS_PARAMETERS_HLSL
#define PENUMBRA_FIELD_SHADOWS_PARAMETERS_HLSL

struct FieldShadowsParameters
{
    int fieldSteps; // fetches: steps along each ray or cone through an object's box, 1 to 256
    float fieldFarthestMetres; // m: objects farther from the receiver than this cast nothing
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
