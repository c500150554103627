// Shadows of balls that stand for objects.
// Written by `penumbra emit` from Shaders/PenumbraBlobs.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_BLOB_PARAMETERS_HLSL
#define PENUMBRA_BLOB_PARAMETERS_HLSL

struct BlobParameters
{
    // m: height of a ball's lowest point over the receiver at which its shadow has faded; 0: no shadow fades
    float blobFadeMetres;
};

// Unpacks the uniforms _PenumbraBlobParameters0, which the package's C# struct of the same name sets.
BlobParameters UnpackBlobParameters(float4 packed0)
{
    BlobParameters parameters;
    parameters.blobFadeMetres = packed0.x;
    return parameters;
}

#endif
