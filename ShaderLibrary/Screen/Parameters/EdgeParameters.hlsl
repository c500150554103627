// Which samples of a pixel count as different surfaces.
// Written by `penumbra emit` from ShaderLibrary/Screen/SampleEdges.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_EDGE_PARAMETERS_HLSL
#define PENUMBRA_EDGE_PARAMETERS_HLSL

struct EdgeParameters
{
    // 1: samples of a pixel: 2, 4 or 8
    int edgeSamples;
    // pixels: plane distance threshold, in pixel footprints: a sample farther from another's plane is on another
    // surface
    float depthTolerance;
    // 1: cosine of the largest angle between the normals of samples on one surface
    float normalCosine;
};

// Unpacks the uniforms _PenumbraEdgeParameters0, which the package's C# struct of the same name sets.
EdgeParameters UnpackEdgeParameters(float4 packed0)
{
    EdgeParameters parameters;
    parameters.edgeSamples = int(packed0.x);
    parameters.depthTolerance = packed0.y;
    parameters.normalCosine = packed0.z;
    return parameters;
}

#endif
