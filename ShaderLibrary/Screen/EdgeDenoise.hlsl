// Penumbra: smoothing of noise in penumbrae along surfaces, not across their edges.
//
// Computes:   a tent-weighted mean of visibility along one direction; each tap is weighted by its distance to
//             the straight line that continues this pixel's surface, and by its difference in visibility.
//
//                 depth       . x          x: another surface, weight 0
//                       o o o o o          o: on the line
//                 pixel -2 -1 0 1 2
//
// Source:     Tomasi and Manduchi, "Bilateral Filtering for Gray and Color Images" (1998), in one direction at a time;
//             its range weights use the distance to the surface, whose depth is linear over the screen
//             (ScreenPosition.hlsl), and the amplitude of the noise.
// Inputs:     visibility and camera depth at the screen's size; ScreenView; direction: (1, 0) or (0, 1);
//             DenoiseParameters.
// Cost:       2 radius + 1 fetches, twice that where they are not all 0 or all 1, and up to 2 more next to edges.
// Guarantees: [0, 1], never NaN. Exactly 0 or 1 where the whole neighbourhood is, and there no depth is read. Reads no
//             texel outside the screen. radius at most kLargestDenoiseRadius.
// Use it:     horizontally, then vertically, after a noisy filter. Not: after a fixed one, which has no noise and
//             would only lose sharpness.
#ifndef PENUMBRA_EDGE_DENOISE_HLSL
#define PENUMBRA_EDGE_DENOISE_HLSL

#include "CameraSurface.hlsl"
#include "Parameters/DenoiseParameters.hlsl"

static const int kLargestDenoiseRadius = 8;

// The continuation of a surface to either side of a pixel, as stored depth.
struct SurfaceLine
{
    float depth;
    float slope;          // change of depth per pixel
    float metresPerDepth; // distance from the line, per unit of stored depth
    float tolerance;      // metres
};

SurfaceLine SurfaceLineAt(TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, int2 pixel, int2 direction, float depth,
                          float tolerancePixels)
{
    const ScreenPoint at = ScreenPointOf(view.screenToWorld, (float2(pixel) + 0.5) * view.size.zw, depth);
    const float slope = ReadDepthSlope(cameraDepth, view, pixel, direction, depth);
    const float2 toNext = float2(direction) * view.size.zw;
    SurfaceLine along;
    along.depth = depth;
    along.slope = abs(slope) < kNoDepthSlope ? slope : 0.0;
    const float3 tangent = ScreenTangent(view.screenToWorld, at, float3(toNext, along.slope));
    const float3 away = ScreenTangent(view.screenToWorld, at, float3(0.0, 0.0, 1.0));
    along.metresPerDepth = length(cross(tangent, away)) / max(length(tangent), 1e-20);
    along.tolerance = tolerancePixels * MetresPerPixel(view.screenToWorld, at, view.size.zw);
    return along;
}

// steps counts pixels from the one that the line belongs to.
float LineWeight(SurfaceLine along, float depth, int steps)
{
    if (!IsSurfaceDepth(depth)) return 0.0;
    const float beside = abs(depth - (along.depth + float(steps) * along.slope)) * along.metresPerDepth;
    if (!HasFiniteBits(beside) || !(beside < along.tolerance)) return 0.0;
    return 1.0 - beside / along.tolerance;
}

// A difference larger than noise belongs to the shadow.
float NoiseWeight(float difference, float amplitude)
{
    return max(1.0 - abs(difference) / max(amplitude, 1e-6), 0.0);
}

bool IsOnScreen(ScreenView view, int2 pixel)
{
    return all(pixel >= 0) && all(pixel < int2(view.size.xy));
}

// Whether all visibilities within the radius are 0, or all are 1: there is nothing to smooth then.
bool IsSettled(TEXTURE2D_X(visibility), ScreenView view, int2 pixel, int2 direction, int radius, float here)
{
    if (here > 0.0 && here < 1.0) return false;
    UNITY_LOOP
    for (int i = -radius; i <= radius; ++i)
    {
        const int2 beside = pixel + i * direction;
        if (i == 0 || !IsOnScreen(view, beside)) continue;
        if (LOAD_TEXTURE2D_X(visibility, beside).x != here) return false;
    }
    return true;
}

float DenoiseEdges(TEXTURE2D_X(visibility), TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, int2 pixel, int2 direction,
                   DenoiseParameters parameters)
{
    const int radius = min(max(parameters.denoiseRadius, 0), kLargestDenoiseRadius);
    const float here = SanitizeVisibility(LOAD_TEXTURE2D_X(visibility, pixel).x);
    if (IsSettled(visibility, view, pixel, direction, radius, here)) return here;
    const float depth = ReadCameraDepth(cameraDepth, view, pixel);
    if (!IsSurfaceDepth(depth)) return here;
    const SurfaceLine along =
        SurfaceLineAt(cameraDepth, view, pixel, direction, depth, parameters.planeTolerance);
    float change = 0.0;
    float weights = float(radius + 1);
    UNITY_LOOP
    for (int i = -radius; i <= radius; ++i)
    {
        const int2 beside = pixel + i * direction;
        if (i == 0 || !IsOnScreen(view, beside)) continue;
        const float apart = SanitizeVisibility(LOAD_TEXTURE2D_X(visibility, beside).x) - here;
        const float alike = NoiseWeight(apart, parameters.noiseAmplitude);
        if (!(alike > 0.0)) continue;
        const float weight =
            float(radius + 1 - abs(i)) * alike * LineWeight(along, ReadCameraDepth(cameraDepth, view, beside), i);
        change += weight * apart;
        weights += weight;
    }
    return SanitizeVisibility(here + change / weights);
}

#endif
