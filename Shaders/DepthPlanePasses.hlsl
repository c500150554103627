// Penumbra: the passes that make the map of depth planes.
//
// Computes:   QuarterDepthPlanes  planes of every 4 x 4 texels of the shadow map
//             DepthPlanesMip      planes of 2 x 2 texels of the level before
// Source:     Map/DepthPlanes.hlsl.
// Inputs:     those of DepthRangePasses.hlsl; _PenumbraMip.
// Cost:       4 gathers; 4 loads.
// Guarantees: those of DepthRangePasses.hlsl.
// Use it:     as passes that run for each cascade, into 32-bit floats.
#ifndef PENUMBRA_DEPTH_PLANE_PASSES_HLSL
#define PENUMBRA_DEPTH_PLANE_PASSES_HLSL

#include "DepthRangePasses.hlsl"
#include "../ShaderLibrary/Map/DepthPlanes.hlsl"

int _PenumbraMip;

float4 QuarterDepthPlanes(ScreenVaryings input) : SV_Target
{
    float4 depths[4];
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i) depths[i] = BlockDepths(int2(input.positionCS.xy), i);
    return PackPlanes(PlanesOfBlock(depths));
}

float4 DepthPlanesMip(ScreenVaryings input) : SV_Target
{
    const int2 first = 2 * int2(input.positionCS.xy);
    DepthPlanes parts[4];
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
        parts[i] = UnpackPlanes(LOAD_TEXTURE2D_X(_PenumbraSourceTexture, first + int2(i & 1, i >> 1)));
    return PackPlanes(JoinPlanes(parts, kRangeBlock * PowerOfTwo(_PenumbraMip - 1)));
}

#endif
