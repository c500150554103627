// Shadows flattened onto a plane.
// Written by `penumbra emit` from Shaders/PenumbraPlanar.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_PLANAR_PARAMETERS_HLSL
#define PENUMBRA_PLANAR_PARAMETERS_HLSL

struct PlanarParameters
{
    // m: height over the plane of what casts no shadow any more; 0: no shadow fades
    float planarFadeMetres;
    // m: how far from the plane a surface may lie that receives its shadows
    float planarToleranceMetres;
};

// Unpacks the uniforms _PenumbraPlanarParameters0, which the package's C# struct of the same name sets.
PlanarParameters UnpackPlanarParameters(float4 packed0)
{
    PlanarParameters parameters;
    parameters.planarFadeMetres = packed0.x;
    parameters.planarToleranceMetres = packed0.y;
    return parameters;
}

#endif
