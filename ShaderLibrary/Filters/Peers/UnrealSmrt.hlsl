// Penumbra: shadow map ray tracing (SMRT) by the rules of Unreal Engine, for comparison.
//
// Computes:   the share of a few rays to the light's disc that pass the surfaces of the shadow map. A ray is sampled
//             from the light's end to the receiver, at t = ((N - 1 - i + offset) / N)^2 for sample i of N and at 0:
//
//                t = 1 \                  A surface above the ray by less than 1.05 of the ray's change of depth since
//                       \                 the sample before is a hit: the ray has just passed through it. One farther
//                  ------\--- caster      above is a caster that the ray passes behind: instead of it, the surface
//                         \               before it counts, continued with its slope.
//                   t = 0  . receiver
//
// Source:     Unreal Engine 5's virtual shadow maps: the console variables r.Shadow.Virtual.SMRT.* and NormalBias with
//             their descriptions and the defaults of 5.4 (7 rays, 8 samples per ray, ray length 1.5 times the distance
//             to the camera, texel dither 2, largest extrapolated slope 5, in Unreal's centimetres, normal bias 0.5),
//             and the rule of a hit as "Virtual Shadow Maps Deep Dive" (chay116/techblog, 2025) describes it.
// Inputs:     shadow map (raw reads; the comparison sampler is not used), point sampler; ShadowReceiver; ShadowTile;
//             UnrealSmrtParameters.
// Cost:       rays (samplesPerRay + 1) fetches where no ray hits, fewer where rays end early: at most 63 by default.
// Guarantees: [0, 1] for any input; exactly 1 without blockers; exactly 0 below a wall that is above the receiver's
//             plane at every ray (the plane of a surface along the light's rays passes the near plane); texels outside
//             the tile are not read.
// Use it:     for comparison with Unreal Engine; the renderer feature does not offer it. Not: with so few rays without
//             the temporal filter that Unreal has after it.
//
// What is different here:
// - A cascade's tile takes the place of pages and clipmap levels. Samples outside the tile are omitted, where Unreal
// goes
//   on in a coarser level; that at the receiver is taken inside it.
// - Filters do not know the distance to the camera, by which Unreal scales the ray's length and the normal bias: half
// the
//   tile's width takes its place, as the width of a clipmap's level follows that distance. Rays twice as long change
//   the error in penumbrae by -0.01, rays half as long by 0.03.
// - Unreal first traces a short ray in the depth buffer, and reads blue noise. Neither is known to a filter: each pixel
//   has one random number, of which the others are made.
// - All rays are traced. Unreal stops early where all pixels of a wave agree (AdaptiveRayCount), for speed alone.
// - The light's angular diameter a is Unreal's source angle. The disc's radius at a distance of 1 is tan(a/2), as
//   everywhere here; in Unreal it is sin(a/2).
// - A sample's time and that before it differ, so the slope is finite for any number of samples.
// - Bias: Unreal draws casters without one. The tolerance takes its place, with the normal bias and, for the dither,
// twice
//   the rise of the receiver's plane. They are meant for maps with a texel per pixel. Here casters are drawn with
//   Unity's slope-scaled bias all the same: a cascade's texels are larger, and without it more lit surfaces shadow
//   themselves.
#ifndef PENUMBRA_UNREAL_SMRT_HLSL
#define PENUMBRA_UNREAL_SMRT_HLSL

#include "../Taps/DepthTaps.hlsl"
#include "../Taps/ReceiverNormal.hlsl"
#include "../../Core/Disk.hlsl"
#include "Parameters/UnrealSmrtParameters.hlsl"

static const float kSmrtTolerance = 1.05;        // share of the ray's change of depth in a step
static const float kSmrtSmallestOffset = 0.0002; // metres along the normal
static const float kSmrtDitherTexels = 0.5;      // texels per unit of the dither's scale
static const float kSmrtBiasOfDither = 2.0;

// A ray from the receiver, for t from 0 to 1. Heights are stored depths, larger toward the light.
struct SmrtRay
{
    float2 start; // texels
    float2 along; // texels per t
    float height;
    float rise;   // change of height per t
    float largestSlope; // largest change of height per t
};

// Two random numbers in [0, 1): element `index` of the R2 sequence (Roberts 2018), from a pixel's own start.
float2 SmrtRandom(float2 start, int index)
{
    return frac(start + float(index) * float2(0.754877669, 0.569840296));
}

// Maps the unit square to the unit disk by concentric squares (Shirley and Chiu 1997).
float2 SmrtDisk(float2 square)
{
    const float2 s = 2.0 * square - 1.0;
    const bool wide = abs(s.x) > abs(s.y);
    const float radius = wide ? s.x : s.y;
    if (radius == 0.0) return float2(0.0, 0.0);
    const float angle = wide ? 0.78539816 * (s.y / s.x) : 1.57079633 - 0.78539816 * (s.x / s.y);
    return radius * float2(cos(angle), sin(angle));
}

bool SmrtHit(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, SmrtRay ray, int samples, float offset)
{
    bool known = false; // whether there is a surface, at `surface` when the ray was at `surfaceTime`
    float surface = 0.0;
    float surfaceTime = 1.0;
    float slope = 0.0;
    float before = 0.0; // the ray's height at the sample before
    bool hit = false;
    UNITY_LOOP
    for (int i = 0; i <= samples && !hit; ++i)
    {
        const float left = max(float(samples - 1 - i) + offset, 0.0) / float(samples);
        const float time = i == samples ? 0.0 : left * left;
        const float2 onRay = ray.start + ray.along * time;
        const float2 texels = i == samples ? ClampToTile(onRay, receiver.bounds) : onRay;
        if (InTile(texels, receiver.bounds))
        {
            const float height = ray.height + ray.rise * time;
            const float mapDepth = PointDepth(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, texels);
            const float mapHeight = DepthGap(mapDepth, kFarthestDepth);
            if (!known)
            {
                hit = mapHeight > height;
                surface = mapHeight;
                surfaceTime = time;
                known = true;
            }
            else
            {
                const float tolerance = kSmrtTolerance * abs(height - before);
                const float passed = min(time - surfaceTime, -1e-7);
                float compared = mapHeight;
                if (mapHeight - height > tolerance)
                {
                    compared = surface + slope * passed;
                }
                else if (mapHeight != surface)
                {
                    slope = min(max((mapHeight - surface) / passed, -ray.largestSlope), ray.largestSlope);
                    surface = mapHeight;
                    surfaceTime = time;
                }
                hit = compared > height && compared - height < tolerance;
            }
            before = height;
        }
    }
    return hit;
}

// All rays of a receiver share these.
struct SmrtBase
{
    QuadReceiver receiver; // receiver, moved along its normal
    float rise;            // rise of a ray, stored depth
    float dither;          // width of the dither of a ray's start from side to side, texels
};

SmrtBase SmrtBaseOf(ShadowReceiver receiver, ShadowTile tile, ConeScales scales, UnrealSmrtParameters parameters)
{
    const QuadReceiver surface = PrepareQuads(receiver, tile);
    // This length takes the place of the distance to the camera, metres.
    const float viewDistance = 0.5 * scales.largestRadius / max(scales.texelsPerMetre, 1e-6);
    const float away = max(BoundedOrLow(parameters.normalBias, 0.0, 1e3) * 1e-3 * viewDistance, kSmrtSmallestOffset);
    SmrtBase base;
    base.receiver = MoveReceiver(surface, ReceiverNormalLS(surface, scales) * away, scales);
    base.rise = min(BoundedOrLow(parameters.rayLengthScale, 0.0, 1e3) * viewDistance * scales.depthPerMetre, 1e3);
    base.dither = kSmrtDitherTexels * BoundedOrLow(parameters.texelDither, 0.0, 64.0);
    return base;
}

float FilterUnrealSmrt(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                       ShadowReceiver receiver, ShadowTile tile, UnrealSmrtParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const SmrtBase base = SmrtBaseOf(receiver, tile, scales, parameters);
    const QuadReceiver prepared = base.receiver;

    SmrtRay ray;
    ray.rise = base.rise;
    ray.largestSlope = BoundedOrLow(parameters.largestSlopeMetres, 0.0, 1e6) * scales.depthPerMetre;

    const float2 rotation = UnitRotation(receiver.rotation);
    const float noise = frac(atan2(rotation.y, rotation.x) * 0.15915494 + 1.0);
    const float2 start = float2(noise, frac(noise * 29.0));
    const float offset = frac(noise * 11.0);
    const int rays = BoundedSampleCount(parameters.rays);
    const int samples = BoundedSampleCount(parameters.samplesPerRay);
    float lit = 0.0;
    UNITY_LOOP
    for (int i = 0; i < rays; ++i)
    {
        const float2 texels = (SmrtRandom(start, i + rays) - 0.5) * base.dither;
        const float planeRise = max(dot(RisePerTexel(prepared), texels), 0.0);
        ray.start = prepared.centre + texels;
        ray.height = DepthGap(prepared.depth, kFarthestDepth) + kSmrtBiasOfDither * planeRise;
        ray.along = SmrtDisk(SmrtRandom(start, i)) * (ray.rise * scales.texelsPerDepth);
        lit += SmrtHit(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, ray, samples, offset) ? 0.0 : 1.0;
    }
    return SanitizeVisibility(MeanVisibility(lit, float(rays)));
}

#endif
