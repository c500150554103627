// Penumbra: far shadows from a height field.
//
// Computes:   HeightFieldVisibility  the share of the sun's disc above the steepest of the ground's slopes that a few
//                                    steps towards the sun find
//             StoredHeight           a height at a place of the map, 0 for the lowest and 1 for the highest
// Source:     Candycat, "Graphics Study: RDR2, shadows" (2021): 8 steps over a height map towards the sun, blended by
//             how far the ground reaches over the ray. Here the blend is the sun's own disc, and the places are nearest
//             + (farthest - nearest) s^2 for s equally spaced in [0, 1), up to where the ray is over all ground. Steps
//             so grow with the root of the distance. Steps in proportion to it, of which a quarter lie within the first
//             hundred metres, are a kilometre long where mountains of an open landscape stand, and step over them.
// Inputs:     heights: one texture, of `penumbra bake heightfield` or of a terrain; its first texel at the smallest x
//             and z, rows along +X. texels: how many each way; the first and last lie on the area's edges. ground:
//             BoundedGroundMap(float4(corner_metres, size_metres), float2(heights_metres)), with the numbers of the
//             bake's JSON file: a stored 0 and 1 mean the first and the second of heights_metres. The receiver's world
//             position; the direction towards the sun, world space, of any positive length; half its angular diameter
//             in radians. HeightFieldRay: nearestMetres, where the ray begins; steps; jitter in [0, 1), another for
//             each pixel; channels, what the heights' red and green are multiplied with, (1, 0) of a bake. A terrain of
//             Unity stores heights up to 32766 / 65535, with Vulkan and OpenGL ES in two channels, red the low byte and
//             green the high one (its PaintContext.kNormalizedHeightScale and UnpackHeightmap).
// Cost:       as many filtered fetches as steps, fewer where the ray leaves the map or all ground before. Heights in
//             two channels take four times as many, not filtered: devices may round filtered texels of 8 bits to 8
//             bits.
// Guarantees: [0, 1] for any input; at most 256 steps; beside the map all is lit; a sun below the horizontal is hidden.
// Use it:     for ground that changes, or a sun that has moved since horizons were baked. Not: for narrow ridges
//             between two steps, which are missed.
#ifndef PENUMBRA_HEIGHT_FIELD_TRACE_HLSL
#define PENUMBRA_HEIGHT_FIELD_TRACE_HLSL

#include "HorizonAngles.hlsl"

struct HeightFieldRay
{
    float nearestMetres; // distance of the first step
    int steps;           // at most 256
    float jitter;        // [0, 1)
    float2 channels;     // factors of the heights' red and green
};

// The height in two channels, which no sampler joins, is interpolated between the four texels around a place.
float HeightBetweenTexels(TEXTURE2D(heights), float2 texels, float2 groundUv, float2 channels)
{
    const float2 last = float2(BoundedOrLow(texels.x, 2.0, 65536.0), BoundedOrLow(texels.y, 2.0, 65536.0)) - 1.0;
    const float2 place = float2(BoundedOrLow(groundUv.x, 0.0, 1.0), BoundedOrLow(groundUv.y, 0.0, 1.0)) * last;
    const float2 corner = min(floor(place), last - 1.0);
    const int2 first = int2(corner);
    const float low = dot(LOAD_TEXTURE2D_LOD(heights, first, 0).rg, channels);
    const float right = dot(LOAD_TEXTURE2D_LOD(heights, first + int2(1, 0), 0).rg, channels);
    const float up = dot(LOAD_TEXTURE2D_LOD(heights, first + int2(0, 1), 0).rg, channels);
    const float both = dot(LOAD_TEXTURE2D_LOD(heights, first + int2(1, 1), 0).rg, channels);
    const float2 part = place - corner;
    return lerp(lerp(low, right, part.x), lerp(up, both, part.x), part.y);
}

// The height at a place: 0 at ground.low, 1 at the highest ground.
float StoredHeight(TEXTURE2D(heights), SAMPLER(sampler_linear), float2 texels, float2 groundUv, float2 channels)
{
    float height;
    UNITY_BRANCH
    if (channels.y > 0.0) height = HeightBetweenTexels(heights, texels, groundUv, channels);
    else height = SAMPLE_TEXTURE2D_LOD(heights, sampler_linear, HeightUv(groundUv, texels), 0.0).r * channels.x;
    return height;
}

float HeightFieldVisibility(TEXTURE2D(heights), SAMPLER(sampler_linear), float2 texels, float3 positionWS,
                            float3 towardSun, float halfDiameter, HeightFieldRay ray, GroundMap ground)
{
    const float elevation = ElevationOf(towardSun);
    if (!(elevation > 0.0)) return 0.0;
    const float2 level = float2(FiniteOr(towardSun.x, 0.0), FiniteOr(towardSun.z, 0.0));
    const float2 bounded = min(max(level, -1e15), 1e15);
    const float2 direction = bounded * rsqrt(max(dot(bounded, bounded), 1e-30));
    const float2 from = GroundUv(positionWS, ground);
    if (GroundCoverage(positionWS, from) == 0.0) return 1.0;

    const float halfAngle = BoundedOrLow(halfDiameter, 0.0, 1.0);
    const float height = BoundedOrLow(positionWS.y, -1e5, 1e5);
    // From this distance on the lowest ray of the disc is over all ground. At least the first step is made.
    const float rise = max(tan(min(max(elevation - halfAngle, 1e-3), 1.5)), 1e-3);
    const float nearest = BoundedOrLow(ray.nearestMetres, 1e-2, 1e6);
    const float farthest = max((ground.low + ground.span - height) / rise, nearest);
    const int steps = min(max(ray.steps, 1), 256);
    const float jitter = BoundedOrLow(ray.jitter, 0.0, 1.0);
    float steepest = 0.0;
    UNITY_LOOP
    for (int i = 0; i < steps; ++i)
    {
        const float part = (float(i) + jitter) / float(steps);
        const float distance = nearest + (farthest - nearest) * part * part;
        const float2 uv = from + direction * distance / ground.size;
        if (any(uv < 0.0) || any(uv > 1.0)) break;
        const float stored = StoredHeight(TEXTURE2D_ARGS(heights, sampler_linear), texels, uv, ray.channels);
        steepest = max(steepest, (GroundHeight(stored, ground) - height) / distance);
    }
    return HorizonVisibility(atan(steepest), elevation, halfAngle);
}

#endif
