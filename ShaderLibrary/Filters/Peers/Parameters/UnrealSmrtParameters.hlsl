// SMRT (Unreal): shadow map ray tracing with the parameters of Unreal Engine.
// Written by `penumbra emit` from ShaderLibrary/Filters/Peers/UnrealSmrt.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_UNREAL_SMRT_PARAMETERS_HLSL
#define PENUMBRA_UNREAL_SMRT_PARAMETERS_HLSL

struct UnrealSmrtParameters
{
    // rays: rays to the light's disc, 1 to 64
    int rays;
    // fetches: samples of a ray beside that at the receiver, 1 to 64
    int samplesPerRay;
    // 1: length of a ray, in halves of the tile's width
    float rayLengthScale;
    // 1: random offset of a ray, in half texels from side to side
    float texelDither;
    // m: largest change of depth along a ray, with which a surface is continued behind a caster
    float largestSlopeMetres;
    // 1: distance of the receiver from its surface, in thousandths of half the tile's width
    float normalBias;
};

// Unpacks the uniforms _PenumbraUnrealSmrtParameters0, _PenumbraUnrealSmrtParameters1, which the package's C# struct of
// the same name sets.
UnrealSmrtParameters UnpackUnrealSmrtParameters(float4 packed0, float4 packed1)
{
    UnrealSmrtParameters parameters;
    parameters.rays = int(packed0.x);
    parameters.samplesPerRay = int(packed0.y);
    parameters.rayLengthScale = packed0.z;
    parameters.texelDither = packed0.w;
    parameters.largestSlopeMetres = packed1.x;
    parameters.normalBias = packed1.y;
    return parameters;
}

#endif
