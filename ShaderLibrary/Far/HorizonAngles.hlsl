// Penumbra: far shadows from horizon angles.
//
// Computes:   visibility of the sun from the ground: the share of its disc above a horizon that is known in eight
//             directions.
// Source:     Max, "Horizon mapping: shadows for bump-mapped surfaces" (1988); Candycat, "Graphics Study: RDR2, shadows"
//             (2021): eight directions in two textures of four channels over the whole map, compared with the sun's pitch.
// Inputs:     angles: two textures of `penumbra bake horizon`, a quarter turn at 1; the world position of the receiver; the
//             direction towards the sun, world space, of any positive length; half its angular diameter in radians.
// Cost:       2 filtered fetches of four channels.
// Guarantees: [0, 1] for any input; beside the map all is lit; a sun below the horizontal is hidden.
// Use it:     for mountains and hills beyond the cascades. Not: near what casts the shadow, where a texel is wide and eight
//             directions are few; nor high over the ground, for which the horizon of the ground below is too high.
#ifndef PENUMBRA_HORIZON_ANGLES_HLSL
#define PENUMBRA_HORIZON_ANGLES_HLSL

#include "../Platform/Platform.hlsl"
#include "../Core/GroundMap.hlsl"
#include "../Core/HorizonBlend.hlsl"

static const float kQuarterTurn = 1.57079633;

// Radians above the horizontal; of a direction without length a quarter turn down.
float ElevationOf(float3 towardSun)
{
    const float3 finite = float3(FiniteOr(towardSun.x, 0.0), FiniteOr(towardSun.y, -1.0), FiniteOr(towardSun.z, 0.0));
    const float3 bounded = min(max(finite, -1e15), 1e15);
    const float level = sqrt(bounded.x * bounded.x + bounded.z * bounded.z);
    return level > 0.0 ? atan2(bounded.y, level) : bounded.y > 0.0 ? kQuarterTurn : -kQuarterTurn;
}

float HorizonAnglesVisibility(TEXTURE2D(firstAngles), TEXTURE2D(secondAngles), SAMPLER(sampler_linear), float3 positionWS,
                              float3 towardSun, float halfDiameter, GroundMap ground)
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
