// Penumbra: tent-weighted percentage-closer filters.
//
// Computes:   the share of a tent, 3, 5 or 7 texels wide, under which the map does not block the receiver; flat, along
//             the receiver's plane, or with a bias that adapts to both (Core/TentWeights.hlsl draws the kernel).
// Source:     weights derived in Core/TentWeights.hlsl; plane: Isidoro, GDC 2006; adaptive bias: after Dou et al.,
//             I3D 2014.
// Inputs:     shadow map with comparison sampler; ShadowReceiver; ShadowTile.
// Cost:       3 x 3: 4 fetches, 5 x 5: 9, 7 x 7: 16.
// Guarantees: [0, 1]; exactly 1 when no comparison fails, exactly 0 when all do.
// Use it:     wherever the penumbra is about as wide as the tent: thin penumbrae, far cascades, small devices.
#ifndef PENUMBRA_TENT_PCF_HLSL
#define PENUMBRA_TENT_PCF_HLSL

#include "../Taps/CompareFetch.hlsl"
#include "../../Core/ShadowBias.hlsl"
#include "../../Core/TentWeights.hlsl"

// taps is the number of taps per axis, a compile-time 2, 3 or 4.
float TentMean(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), CompareReceiver prepared, int taps)
{
    const TentAxis across = TentFetches(prepared.centre.x, taps);
    const TentAxis down = TentFetches(prepared.centre.y, taps);
    float visibility = 0.0;
    UNITY_UNROLL
    for (int y = 0; y < taps; ++y)
    {
        float row = 0.0;
        UNITY_UNROLL
        for (int x = 0; x < taps; ++x)
        {
            row += across.weight[x] * CompareFetch(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared,
                                                   float2(across.position[x], down.position[y]));
        }
        visibility += down.weight[y] * row;
    }
    return SanitizeVisibility(visibility);
}

float TentFlat(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver, ShadowTile tile,
               int taps)
{
    const CompareReceiver prepared = PrepareCompare(receiver, tile, float2(0.0, 0.0), 0.0);
    return TentMean(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared, taps);
}

float TentOnPlane(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver, ShadowTile tile,
                  int taps)
{
    const CompareReceiver prepared = PrepareCompare(receiver, tile, receiver.depthGradient, 0.0);
    return TentMean(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared, taps);
}

// The bias lifts every tap above the receiver's plane, at most by one percent of the map's depth.
float TentAdaptive(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver, ShadowTile tile,
                   int taps)
{
    const float2 texelSize = 1.0 / max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    const float reach = 0.5 * (2.0 * float(taps) - 1.0);
    const float bias = AdaptiveBias(BoundGradient(receiver.depthGradient), reach * texelSize, 0.01);
    const CompareReceiver prepared = PrepareCompare(receiver, tile, float2(0.0, 0.0), bias);
    return TentMean(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared, taps);
}

#define PENUMBRA_TENT_FILTER(name, kernel, taps)                                                                  \
    float name(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver, ShadowTile tile)   \
    {                                                                                                            \
        return kernel(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, tile, taps);                \
    }

PENUMBRA_TENT_FILTER(FilterTent3x3, TentFlat, 2)
PENUMBRA_TENT_FILTER(FilterTent5x5, TentFlat, 3)
PENUMBRA_TENT_FILTER(FilterTent7x7, TentFlat, 4)
PENUMBRA_TENT_FILTER(FilterTent3x3Plane, TentOnPlane, 2)
PENUMBRA_TENT_FILTER(FilterTent5x5Plane, TentOnPlane, 3)
PENUMBRA_TENT_FILTER(FilterTent7x7Plane, TentOnPlane, 4)
PENUMBRA_TENT_FILTER(FilterTent5x5Adaptive, TentAdaptive, 3)

#endif
