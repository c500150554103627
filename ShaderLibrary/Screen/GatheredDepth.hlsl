// Penumbra: what CameraSurface.hlsl reads of a pixel and its neighbours, by gathers.
//
// Computes:   stored depth of a pixel, and its change to the next pixels.
// Source:     Screen/CameraSurface.hlsl.
// Inputs:     the camera's depth, point sampler; ScreenView; pixel of the screen.
// Cost:       2 gathers, and up to 4 loads more at edges.
// Guarantees: the values that ReadCameraSurface has.
// Use it:     where the camera's depth can be gathered. Not: in a file that programs without gather include, since
//             URP's macro is an error there on OpenGL.
#ifndef PENUMBRA_GATHERED_DEPTH_HLSL
#define PENUMBRA_GATHERED_DEPTH_HLSL

#include "CameraSurface.hlsl"

// A pixel's depth, and the change of stored depth to the next pixel along both axes: kNoDepthSlope where none is known.
struct DepthAndSlope
{
    float depth;
    float2 slope;
};

DepthAndSlope GatherDepthAndSlope(TEXTURE2D_X_FLOAT(cameraDepth), SAMPLER(sampler_point), ScreenView view, int2 pixel)
{
    const float4 low = GATHER_RED_TEXTURE2D_X(cameraDepth, sampler_point, float2(pixel) * view.size.zw);
    const float4 high = GATHER_RED_TEXTURE2D_X(cameraDepth, sampler_point, float2(pixel + 1) * view.size.zw);
    // At the screen's border a gather repeats pixels where none are.
    const bool2 isFirst = bool2(pixel.x == 0, pixel.y == 0);
    const bool2 isLast = bool2(pixel.x == int(view.size.x) - 1, pixel.y == int(view.size.y) - 1);
    DepthLine across, down;
    across.here = low.y;
    across.before = isFirst.x ? 0.0 : low.x;
    across.after = isLast.x ? 0.0 : high.z;
    down.here = low.y;
    down.before = isFirst.y ? 0.0 : low.z;
    down.after = isLast.y ? 0.0 : high.x;
    DepthAndSlope read;
    read.depth = low.y;
    read.slope = float2(kNoDepthSlope, kNoDepthSlope);
    UNITY_BRANCH
    if (IsSurfaceDepth(low.y))
    {
        read.slope.x = DepthSlopeAlong(cameraDepth, view, pixel, int2(1, 0), across);
        read.slope.y = DepthSlopeAlong(cameraDepth, view, pixel, int2(0, 1), down);
    }
    return read;
}

#endif
