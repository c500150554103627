// Penumbra: half-resolution visibility upsampled to the screen's resolution, where it tells what lies between.
//
// Computes:   bilinear interpolation between the up to four half-resolution pixels around a pixel, each weighted by the
//             distance of its surface to this pixel's plane; nothing where they differ by more than a step, as at the
//             edge of a narrow penumbra, or where none of them saw this pixel's surface: there the caller computes the
//             pixel.
// Source:     Kopf, Cohen, Lischinski and Uyttendaele, "Joint Bilateral Upsampling" (2007), with the distance to the
//             receiver's plane as the range.
// Inputs:     visibility, half the screen's size rounded up (at the pixels of Core/ScreenScale.hlsl); camera
//             depth; ScreenView.
// Cost:       1, 2 or 4 fetches of visibility; where these differ, up to 9 of camera depth for the plane and 1 per tap.
// Guarantees: [0, 1], or negative where the taps do not tell. A pixel at which the half image was computed is copied
//             exactly, and so is a value on which all taps agree. A tap farther from the plane than the tolerance has
//             weight 0.
// Use it:     after a resolve at half resolution, before EdgeDenoise.hlsl.
#ifndef PENUMBRA_EDGE_UPSAMPLE_HLSL
#define PENUMBRA_EDGE_UPSAMPLE_HLSL

#include "CameraSurface.hlsl"
#include "../Core/ScreenScale.hlsl"

// Distance from the plane, in pixel widths, from which a surface counts as another one.
static const float kUpsampleTolerance = 2.0;

// Difference of taps of one surface above which they do not tell what lies between them. A smaller one computes more
// pixels, with less error.
static const float kUpsampleStep = 0.25;
// The same of taps that are weighed by their depth alone.
static const float kUpsampleDepthStep = 0.15;
// The share of its depth by which a tap that counts may be nearer or farther than the pixel.
static const float kUpsampleDepth = 0.02;

struct HalfTaps
{
    int2 first;        // half-resolution pixel of the first tap
    int2 count;        // taps each way, 1 or 2
    float4 visibility; // visibilities in the order (0, 0), (1, 0), (0, 1), (1, 1)
};

// The first tap along one axis, and how many there are. The half image has the last pixel of an odd size, too.
int2 HalfTapsOf(int pixel, int halfSize, int size)
{
    const bool isSeen = (pixel & 1) == 1 || pixel == size - 1;
    const int before = isSeen ? pixel >> 1 : HalfPixelBefore(pixel);
    const int first = min(max(before, 0), halfSize - 1);
    return int2(first, max(min(isSeen ? before : before + 1, halfSize - 1) - first, 0) + 1);
}

HalfTaps HalfTapsAround(int2 pixel, int2 halfSize, int2 size)
{
    const int2 ofColumns = HalfTapsOf(pixel.x, halfSize.x, size.x);
    const int2 ofRows = HalfTapsOf(pixel.y, halfSize.y, size.y);
    HalfTaps taps;
    taps.first = int2(ofColumns.x, ofRows.x);
    taps.count = int2(ofColumns.y, ofRows.y);
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

HalfTaps ReadHalfTaps(TEXTURE2D_X(visibility), int2 pixel, int2 halfSize, int2 size)
{
    HalfTaps taps = HalfTapsAround(pixel, halfSize, size);
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        if (HasTap(taps, i)) taps.visibility[i] = SanitizeVisibility(LOAD_TEXTURE2D_X(visibility, TapOf(taps, i)).x);
    }
    return taps;
}

// Whether all taps are equal. The first tap, which there always is, is then the answer.
bool TapsAgree(HalfTaps taps)
{
    bool agree = true;
    UNITY_UNROLL
    for (int i = 1; i < 4; ++i) agree = agree && (!HasTap(taps, i) || taps.visibility[i] == taps.visibility.x);
    return agree;
}

// here is the surface seen at the pixel. The result is negative where the taps do not tell.
float UpsampleOverPlane(TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, CameraSurface here, HalfTaps taps)
{
    if (dot(here.normalWS, here.normalWS) <= 0.0) return -1.0;  // no plane is known
    float sum = 0.0;
    float weights = 0.0;
    float lowest = 1.0;
    float highest = 0.0;
    UNITY_LOOP
    for (int i = 0; i < 4; ++i)
    {
        if (!HasTap(taps, i)) continue;
        const int2 seenAt = FullPixel(TapOf(taps, i), 2, int2(view.size.xy));
        const CameraSurface there = ReadCameraPosition(cameraDepth, view, seenAt);
        if (!there.seen) continue;
        // A pixel between taps is equally far from all of them, so their bilinear weights are equal.
        const float weight =
            PlaneWeight(there.positionWS - here.positionWS, here.normalWS, kUpsampleTolerance * here.metresPerPixel);
        if (!(weight > 0.0)) continue;
        sum += weight * taps.visibility[i];
        weights += weight;
        lowest = min(lowest, taps.visibility[i]);
        highest = max(highest, taps.visibility[i]);
    }
    if (!(weights > 0.0) || highest - lowest > kUpsampleStep) return -1.0;
    return SanitizeVisibility(sum / weights);
}

// The mean of the taps, each weighted by how near its stored camera depth is to that of the pixel; negative where those
// that count do not tell.
float UpsampleByDepth(HalfTaps taps, float depth, float4 depths)
{
    float2 sums = float2(0.0, 0.0); // x: visibility, y: weight
    float lowest = 1.0;
    float highest = 0.0;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const float weight = max(1.0 - abs(depths[i] - depth) / (kUpsampleDepth * depth + 1e-12), 0.0);
        if (!HasTap(taps, i) || !(weight > 0.0)) continue;
        sums += weight * float2(taps.visibility[i], 1.0);
        lowest = min(lowest, taps.visibility[i]);
        highest = max(highest, taps.visibility[i]);
    }
    if (!(sums.y > 0.0) || highest - lowest > kUpsampleDepthStep) return -1.0;
    return SanitizeVisibility(sums.x / sums.y);
}

#endif
