// A procedural layer of clouds, and the map that holds its shadow.
// Written by `penumbra emit` from ShaderLibrary/Far/CloudShadow.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_CLOUD_PARAMETERS_HLSL
#define PENUMBRA_CLOUD_PARAMETERS_HLSL

struct CloudParameters
{
    // m: height of the layer, world space
    float cloudAltitudeMetres;
    // m: side of the map, which lies where the sun shines through the layer on the camera
    float cloudMapMetres;
    // 1: share of the map over which the clouds' shadow fades out, on each side
    float cloudBorder;
    // m: size of the largest octave of the noise: larger values make larger clouds
    float cloudFeatureMetres;
    // 1: 0: no clouds, 1: everywhere
    float cloudCoverage;
    // 1: optical depth straight up where the noise is highest: exp(-density) of the light passes there
    float cloudDensity;
};

// Unpacks the uniforms _PenumbraCloudParameters0, _PenumbraCloudParameters1, which the package's C# struct of the same
// name sets.
CloudParameters UnpackCloudParameters(float4 packed0, float4 packed1)
{
    CloudParameters parameters;
    parameters.cloudAltitudeMetres = packed0.x;
    parameters.cloudMapMetres = packed0.y;
    parameters.cloudBorder = packed0.z;
    parameters.cloudFeatureMetres = packed0.w;
    parameters.cloudCoverage = packed1.x;
    parameters.cloudDensity = packed1.y;
    return parameters;
}

#endif
