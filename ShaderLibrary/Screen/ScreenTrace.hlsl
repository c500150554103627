// Penumbra: shadows of what the camera sees, by a march towards the sun over its depth texture ("contact shadows").
//
// Computes:   ScreenTraceVisibility: visibility of the sun's centre, as far as the camera's depth texture knows. A ray
//             from the receiver is walked in equal steps over the screen, and is blocked where it is behind a seen
//             surface by less than a thickness.
//
//                 sun  .                o: samples. The ray begins above the surface by what half a pixel of its slope
//                        o  |##|          and the rounding of depth can hide, so that a plane never shadows itself.
//                          o|##|
//                     ______\__|____    ##: taken to reach this far behind what is seen
//
// Source:     the length, 12 steps and a share of the view depth for far shadows: Candycat, "Graphics Study: RDR2,
//             shadows" (2021). Stepping over the screen: McGuire and Mara, "Efficient GPU Screen-Space Ray Tracing"
//             (JCGT 2014). Thickness, and fading out at the end of the ray and the border of the screen, as in the
//             screen-space shadows of "Days Gone" (Bend Studio, 2023) and the contact shadows of Unity's HDRP. The
//             offset: a sample is read at a pixel's centre, at most half a pixel each way from the ray. In the plane of
//             equal depth that is a move of |x| <= 1/2 pixel along both axes, which changes the height over the
//             receiver's plane by at most (|n . alongX| + |n . alongY|) / 2: a ray at least that high is in front of
//             the plane there. What rounding adds is moved in stored depth, towards the viewer: two depths, the
//             receiver's and a sample's, are wrong by up to 2^-24 of themselves each, the slopes that the normal is
//             made of by 2^-23 per pixel over two pixels, and each of four sums and products by 2^-24: 10 of these, for
//             which 16 are taken.
// Inputs:     camera depth texture, stored depth; ScreenView; pixel of the full screen; towardSun: world space, of any
//             positive length; jitter: [0, 1), another for each pixel; ScreenTraceParameters.
// Cost:       5 to 9 fetches of camera depth for the surface and up to traceSteps for the ray, as many as it has
//             pixels; none of these where the ray has no length, 1 on the sky.
// Guarantees: [0, 1] for any input. Reads no texel outside the screen, where the march ends; the sky blocks nothing;
//             the ray is clipped at the near plane. A plane that faces the sun does not shadow itself, whatever its
//             slope, if depths are floats. At most 64 samples.
// Use it:     for contacts that the bias or the texels of a shadow map lose, and for small things seen by the camera
//             that no map holds. Not: in place of a map; what the camera does not see casts no shadow, and what it sees
//             has a thickness that is a guess.
#ifndef PENUMBRA_SCREEN_TRACE_HLSL
#define PENUMBRA_SCREEN_TRACE_HLSL

#include "../Core/ScreenRay.hlsl"
#include "CameraSurface.hlsl"
#include "Parameters/ScreenTraceParameters.hlsl"

static const int kMostTraceSteps = 64;

// A ray above its receiver, and how much a hit counts.
struct TraceRay
{
    ScreenRay ray;
    float lengthMetres;
    float thickness; // metres
    float weight;    // weight of a hit at the receiver; 0 where there is nothing to trace
};

// Rises from 0 at `low` to 1 at `high`; where both are equal it is 1 from there on.
float FadeIn(float value, float low, float high)
{
    if (!(high > low)) return value >= low ? 1.0 : 0.0;
    return BoundedOrLow((value - low) / (high - low), 0.0, 1.0);
}

// The direction at unit length; 0 where its length is 0 or not finite.
float3 UnitOrZero(float3 direction)
{
    const float3 finite = float3(FiniteOr(direction.x, 0.0), FiniteOr(direction.y, 0.0), FiniteOr(direction.z, 0.0));
    const float largest = max(max(abs(finite.x), abs(finite.y)), abs(finite.z));
    const float3 scaled = finite / max(largest, 1e-30);
    return largest > 1e-30 ? scaled * rsqrt(dot(scaled, scaled)) : float3(0.0, 0.0, 0.0);
}

static const float kTraceRounding = 9.5367432e-7; // 16 * 2^-24

// The height above the plane with this normal, metres, at which a ray begins.
float TraceOffset(ScreenView view, ScreenPoint at, float3 normal)
{
    const float3 alongX = ScreenTangent(view.screenToWorld, at, float3(view.size.z, 0.0, 0.0));
    const float3 alongY = ScreenTangent(view.screenToWorld, at, float3(0.0, view.size.w, 0.0));
    return 0.5 * (abs(dot(normal, alongX)) + abs(dot(normal, alongY)));
}

// depth is the pixel's, and surface is what is seen there.
TraceRay PrepareTraceRay(ScreenView view, int2 pixel, float depth, CameraSurface surface, float3 towardSun,
                         ScreenTraceParameters parameters)
{
    const float3 origin = float3((float2(pixel) + 0.5) * view.size.zw, depth);
    ScreenPoint at = ScreenPointOf(view.screenToWorld, origin.xy, depth);
    const float3 towardViewer = ScreenTangent(view.screenToWorld, at, float3(0.0, 0.0, MoveTowardLight(0.0, 1.0)));
    // The normal is 0 where no slope is known. It faces nothing then, and nothing is traced.
    const float3 normal = surface.normalWS * (dot(surface.normalWS, towardViewer) < 0.0 ? -1.0 : 1.0);

    const ScreenRay rise = ScreenRayOf(view.screenToWorld, at, origin, normal);
    float3 start = ScreenRayPoint(rise, ScreenRayAlong(rise, TraceOffset(view, at, normal)));
    start.z = MoveTowardLight(start.z, depth * kTraceRounding);
    at = ScreenPointOf(view.screenToWorld, start.xy, start.z);

    const float heightMetres = surface.metresPerPixel * view.size.y;
    TraceRay trace;
    trace.lengthMetres = max(BoundedOrLow(parameters.traceLengthMetres, 0.0, 1e6),
                             BoundedOrLow(parameters.traceHeightShare * heightMetres, 0.0, 1e6));
    trace.thickness = BoundedOrLow(parameters.traceThicknessMetres, 0.0, 1e6) +
                      BoundedOrLow(parameters.traceThicknessShare * heightMetres, 0.0, 1e6);
    trace.ray = ScreenRayOf(view.screenToWorld, at, start, towardSun);
    const float grazing = BoundedOrLow(parameters.traceGrazing, 0.0, 1.0);
    const float pixels = trace.lengthMetres / max(surface.metresPerPixel, 1e-20);
    const float fadePixels = BoundedOrLow(parameters.traceFadePixels, 0.0, 1e6);
    const float facing = dot(normal, towardSun);
    trace.weight = facing > 0.0 ? FadeIn(facing, 0.0, grazing) * FadeIn(pixels, 0.5 * fadePixels, fadePixels) : 0.0;
    return trace;
}

// The weight of a hit after so many metres, at this place of the screen.
float TraceHitWeight(TraceRay trace, float metres, float2 uv, ScreenTraceParameters parameters)
{
    const float left = max(1.0 - metres / max(trace.lengthMetres, 1e-20), 0.0);
    const float border = max(min(min(uv.x, 1.0 - uv.x), min(uv.y, 1.0 - uv.y)), 0.0);
    return trace.weight * FadeIn(left, 0.0, BoundedOrLow(parameters.traceEndFade, 0.0, 1.0)) *
           FadeIn(border, 0.0, BoundedOrLow(parameters.traceBorderFade, 0.0, 0.5));
}

float MarchTraceRay(TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, TraceRay trace, float jitter,
                       ScreenTraceParameters parameters)
{
    const float end = ScreenRayWithin(trace.ray, ScreenRayAlong(trace.ray, trace.lengthMetres));
    if (!HasFiniteBits(end) || !(end > 0.0)) return 1.0;
    const float2 pixels = abs(trace.ray.slope.xy) * end * view.size.xy;
    const float covered = BoundedOrLow(ceil(max(pixels.x, pixels.y)), 1.0, float(kMostTraceSteps));
    const int steps = min(min(max(parameters.traceSteps, 1), kMostTraceSteps), int(covered));
    const float moved = BoundedOrLow(jitter, 0.0, 1.0) * BoundedOrLow(parameters.traceJitter, 0.0, 1.0);
    UNITY_LOOP
    for (int i = 0; i < steps; ++i)
    {
        const float along = end * ((float(i) + 1.0 - moved) / float(steps));
        const float3 here = ScreenRayPoint(trace.ray, along);
        if (!all(here.xy >= 0.0) || !all(here.xy < 1.0)) break;
        const float depth = ReadCameraDepth(cameraDepth, view, int2(here.xy * view.size.xy));
        if (!IsSurfaceDepth(depth) || !IsBlocker(depth, here.z)) continue;
        const float3 seen = ScreenPointOf(view.screenToWorld, here.xy, depth).positionWS;
        const float3 behind = ScreenPointOf(view.screenToWorld, here.xy, here.z).positionWS;
        if (length(behind - seen) < trace.thickness)
            return 1.0 - TraceHitWeight(trace, ScreenRayMetres(trace.ray, along), here.xy, parameters);
    }
    return 1.0;
}

float ScreenTraceVisibility(TEXTURE2D_X_FLOAT(cameraDepth), ScreenView view, int2 pixel, float3 towardSun, float jitter,
                            ScreenTraceParameters parameters)
{
    const bool hasLength = parameters.traceLengthMetres > 0.0 || parameters.traceHeightShare > 0.0;
    const float3 direction = UnitOrZero(towardSun);
    if (!hasLength || !any(direction != 0.0)) return 1.0;
    const float depth = ReadCameraDepth(cameraDepth, view, pixel);
    if (!IsSurfaceDepth(depth)) return 1.0;
    const float2 slope = float2(ReadDepthSlope(cameraDepth, view, pixel, int2(1, 0), depth),
                                ReadDepthSlope(cameraDepth, view, pixel, int2(0, 1), depth));
    const CameraSurface surface = SurfaceWithSlope(view, pixel, depth, slope);
    const TraceRay trace = PrepareTraceRay(view, pixel, depth, surface, direction, parameters);
    if (!(trace.weight > 0.0)) return 1.0;
    return SanitizeVisibility(MarchTraceRay(cameraDepth, view, trace, jitter, parameters));
}

#endif
