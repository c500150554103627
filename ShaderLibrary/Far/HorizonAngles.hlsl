// Penumbra: far shadows from horizon angles.
//
// Computes:   HorizonAnglesVisibility  the share of the sun's disc above a horizon that is known in eight directions
//             ElevationOf              the angle of a direction over the horizontal
// Source:     Max, "Horizon mapping: shadows for bump-mapped surfaces" (1988); Candycat, "Graphics Study: RDR2,
//             shadows" (2021): eight directions in two textures of four channels over the whole map, compared with the
//             sun's pitch.
// Inputs:     angles: the two textures of `penumbra bake horizon`, without sRGB. Red, green, blue and alpha of the
//             first are the horizons towards +Z, 45 degrees from there towards +X, +X, 135 degrees; of the second those
//             towards -Z, 225 degrees, -X, 315 degrees. A stored 0 means 0 degrees, a stored 1 means 90. ground:
//             BoundedGroundMap(float4(corner_metres, size_metres), float2(0, 1)), with the numbers of the bake's JSON
//             file; heights are not used here. The receiver's world position; the direction towards the sun, world
//             space, of any positive length; half its angular diameter in radians.
// Cost:       2 filtered fetches of four channels.
// Guarantees: [0, 1] for any input; beside the map all is lit; a sun below the horizontal is hidden.
// Use it:     for mountains and hills beyond the cascades, under a sun that is high or near one of the eight
//             directions. Not: for a low sun between two of them, where interpolated angles are far off
//             (Documentation~/far-shadows.md has the errors; HeightFieldTrace.hlsl is the way out); near what casts the
//             shadow, where a texel is wide; nor high over the ground, for which the horizon of the ground below is too
//             high.
#ifndef PENUMBRA_HORIZON_ANGLES_HLSL
#define PENUMBRA_HORIZON_ANGLES_HLSL

#include "../Platform/Platform.hlsl"
#include "../Core/GroundMap.hlsl"
#include "../Core/HorizonBlend.hlsl"

static const float kQuarterTurn = 1.57079633; // angle that a stored 1 means

// Radians above the horizontal; a quarter turn down for a direction without length.
float ElevationOf(float3 towardSun)
{
    const float3 finite = float3(FiniteOr(towardSun.x, 0.0), FiniteOr(towardSun.y, -1.0), FiniteOr(towardSun.z, 0.0));
    const float3 bounded = min(max(finite, -1e15), 1e15);
    const float level = sqrt(bounded.x * bounded.x + bounded.z * bounded.z);
    return level > 0.0 ? atan2(bounded.y, level) : bounded.y > 0.0 ? kQuarterTurn : -kQuarterTurn;
}

float HorizonAnglesVisibility(TEXTURE2D(firstAngles), TEXTURE2D(secondAngles), SAMPLER(sampler_linear),
                              float3 positionWS, float3 towardSun, float halfDiameter, GroundMap ground)
{
    const float2 uv = GroundUv(positionWS, ground);
    if (GroundCoverage(positionWS, uv) == 0.0) return 1.0;
    const float4 first = SAMPLE_TEXTURE2D_LOD(firstAngles, sampler_linear, uv, 0.0);
    const float4 second = SAMPLE_TEXTURE2D_LOD(secondAngles, sampler_linear, uv, 0.0);
    const float horizon = kQuarterTurn * BlendedHorizon(first, second, HorizonWeightsOf(towardSun.xz));
    const float elevation = ElevationOf(towardSun);
    return elevation > 0.0 ? HorizonVisibility(horizon, elevation, halfDiameter) : 0.0;
}

#endif
