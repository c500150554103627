// Penumbra: half-resolution visibility upsampled to the screen's resolution.
//
// Computes:   bilinear interpolation between the up to four half-resolution pixels around a pixel, each weighted by the
//             distance of its surface to this pixel's plane.
// Source:     Kopf, Cohen, Lischinski and Uyttendaele, "Joint Bilateral Upsampling" (2007), with the distance to the
//             receiver's plane as the range.
// Inputs:     visibility, half the screen's size rounded up (at the pixels of Core/ScreenScale.hlsl); camera
//             depth; ScreenView.
// Cost:       1, 2 or 4 fetches of visibility; where these differ, up to 9 of camera depth for the plane and 1 per tap.
// Guarantees: [0, 1]. A pixel at which the half image was computed is copied exactly, and so is a value on which all
//             taps agree. A tap farther from the plane than the tolerance has weight 0; if all are, the nearest tap is
//             used.
// Use it:     after a resolve at half resolution, before EdgeDenoise.hlsl.
#ifndef PENUMBRA_EDGE_UPSAMPLE_HLSL
#define PENUMBRA_EDGE_UPSAMPLE_HLSL

#include "CameraSurface.hlsl"
#include "../Core/ScreenScale.hlsl"

// Distance from the plane, in pixel widths, from which a surface counts as another one.
static const float kUpsampleTolerance = 2.0;

struct HalfTaps
{
    int2 first;        // half-resolution pixel of the first tap
    int2 count;        // 1 or 2 of them each way
    float4 visibility; // in the order (0, 0), (1, 0), (0, 1), (1, 1)
};

HalfTaps HalfTapsAround(int2 pixel, int2 halfSize)
{
    const int2 before = int2(HalfPixelBefore(pixel.x), HalfPixelBefore(pixel.y));
    const bool2 isSeen = bool2((pixel.x & 1) == 1, (pixel.y & 1) == 1);
    HalfTaps taps;
    taps.first = min(max(before, 0), halfSize - 1);
    const int2 last = min(before + int2(isSeen.x ? 0 : 1, isSeen.y ? 0 : 1), halfSize - 1);
    taps.count = max(last - taps.first, 0) + 1;
    taps.visibility = float4(0.0, 0.0, 0.0, 0.0);
    return taps;
}

int2 TapOf(HalfTaps taps, int index)
{
    return taps.first + int2(index & 1, index >> 1);
}

bool HasTap(HalfTaps taps, int index)
{
    return (index & 1) < taps.count.x && (index >> 1) < taps.count.y;
}

float UpsampleAcrossEdges(TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, int2 pixel, HalfTaps taps)
{
    const CameraSurface here = ReadCameraSurface(cameraDepth, view, pixel);
    if (!here.seen) return 1.0;
    // Without a plane, the nearest tap is used.
    const bool hasPlane = dot(here.normalWS, here.normalWS) > 0.0;
    float sum = 0.0;
    float weights = 0.0;
    float nearest = 3.402823e38;
    float ofNearest = taps.visibility.x;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        if (!HasTap(taps, i)) continue;
        const int2 seenAt = FullPixel(TapOf(taps, i), 2, int2(view.size.xy));
        const CameraSurface there = ReadCameraPosition(cameraDepth, view, seenAt);
        if (!there.seen) continue;
        const float3 offset = there.positionWS - here.positionWS;
        // A pixel between taps is equally far from all of them, so their bilinear weights are equal.
        const float onPlane = PlaneWeight(offset, here.normalWS, kUpsampleTolerance * here.metresPerPixel);
        const float weight = hasPlane ? onPlane : 0.0;
        sum += weight * taps.visibility[i];
        weights += weight;
        const float beside = dot(offset, offset);
        if (beside < nearest) ofNearest = taps.visibility[i];
        nearest = min(nearest, beside);
    }
    return SanitizeVisibility(weights > 0.0 ? sum / weights : ofNearest);
}

float UpsampleEdges(TEXTURE2D_X(visibility), TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, int2 pixel, int2 halfSize)
{
    HalfTaps taps = HalfTapsAround(pixel, halfSize);
    float lowest = 1.0;
    float highest = 0.0;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        if (!HasTap(taps, i)) continue;
        taps.visibility[i] = SanitizeVisibility(LOAD_TEXTURE2D_X(visibility, TapOf(taps, i)).x);
        lowest = min(lowest, taps.visibility[i]);
        highest = max(highest, taps.visibility[i]);
    }
    if (lowest == highest) return lowest;
    return UpsampleAcrossEdges(cameraDepth, view, pixel, taps);
}

#endif
