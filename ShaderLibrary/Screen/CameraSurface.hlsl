// Penumbra: the surface seen at a pixel, from the camera's depth texture.
//
// Computes:   world position, normal and pixel width of what the camera sees.
// Source:     Core/ScreenPosition.hlsl.
// Inputs:     camera depth texture, stored depth; ScreenView; pixel: of the full-resolution screen, with rows in the
//             order in which the texture stores them.
// Cost:       1 fetch without the normal, 5 with it, up to 9 at edges.
// Guarantees: reads no texel outside the screen; beyond its border there is no surface. `seen` is false for sky, for
//             depths outside (0, 1) and for NaN; then the other fields are undefined.
// Use it:     first in every screen pass. Not: where the surface's normal is available.
#ifndef PENUMBRA_CAMERA_SURFACE_HLSL
#define PENUMBRA_CAMERA_SURFACE_HLSL

#include "../Platform/Platform.hlsl"
#include "../Core/ScreenPosition.hlsl"

struct ScreenView
{
    float4x4 screenToWorld;
    float4 size; // width, height, 1 / width, 1 / height
};

struct CameraSurface
{
    bool seen;
    float3 positionWS;    // metres
    float3 normalWS;      // unit, of either sign; 0 where it was not requested or is not known
    float metresPerPixel; // width of a pixel in the plane of equal depth
};

float ReadCameraDepth(TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, int2 pixel)
{
    const int2 last = int2(view.size.xy) - 1;
    const bool inside = all(pixel >= 0) && all(pixel <= last);
    if (!inside) return 0.0;
    return LOAD_TEXTURE2D_X(cameraDepth, pixel).x;
}

CameraSurface SurfaceWithSlope(ScreenView view, int2 pixel, float depth, float2 slope)
{
    const float2 uv = (float2(pixel) + 0.5) * view.size.zw;
    const ScreenPoint at = ScreenPointOf(view.screenToWorld, uv, depth);
    CameraSurface surface;
    surface.seen = IsSurfaceDepth(depth);
    surface.positionWS = at.positionWS;
    surface.normalWS = ScreenNormal(view.screenToWorld, at, slope, view.size.zw);
    surface.metresPerPixel = MetresPerPixel(view.screenToWorld, at, view.size.zw);
    return surface;
}

CameraSurface ReadCameraPosition(TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, int2 pixel)
{
    const float depth = ReadCameraDepth(cameraDepth, view, pixel);
    return SurfaceWithSlope(view, pixel, depth, float2(kNoDepthSlope, kNoDepthSlope));
}

// along holds the pixel and its neighbours. The second neighbours are read only where the first two disagree: at an
// edge, or on a sharp bend.
float DepthSlopeAlong(TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, int2 pixel, int2 direction, DepthLine along)
{
    if (!ContradictsItself(along)) return NearerSlope(along);
    const float before2 = ReadCameraDepth(cameraDepth, view, pixel - 2 * direction);
    const float after2 = ReadCameraDepth(cameraDepth, view, pixel + 2 * direction);
    return StraighterSlope(before2, along, after2);
}

float ReadDepthSlope(TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, int2 pixel, int2 direction, float depth)
{
    DepthLine along;
    along.before = ReadCameraDepth(cameraDepth, view, pixel - direction);
    along.here = depth;
    along.after = ReadCameraDepth(cameraDepth, view, pixel + direction);
    return DepthSlopeAlong(cameraDepth, view, pixel, direction, along);
}

CameraSurface ReadCameraSurface(TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, int2 pixel)
{
    const float depth = ReadCameraDepth(cameraDepth, view, pixel);
    float2 slope = float2(kNoDepthSlope, kNoDepthSlope);
    UNITY_BRANCH
    if (IsSurfaceDepth(depth))
    {
        slope.x = ReadDepthSlope(cameraDepth, view, pixel, int2(1, 0), depth);
        slope.y = ReadDepthSlope(cameraDepth, view, pixel, int2(0, 1), depth);
    }
    return SurfaceWithSlope(view, pixel, depth, slope);
}

#endif
