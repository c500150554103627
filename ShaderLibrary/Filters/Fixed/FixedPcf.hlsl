// Penumbra: percentage-closer filters with fixed kernels of equal weights.
//
// Computes:   the mean of bilinear comparisons at N x N neighbouring texels (N = 1, 3, 5, 7, 9), and the same 3 x 3
//             footprint from four:
//
//                 1 2 1      o at the four corners of the centre texel: every bilinear fetch covers
//                 2 4 2      2 x 2 texels, and together they weight the texels as on the left when the
//                 1 2 1      receiver is at a texel's centre
//
// Source:     Reeves, Salesin and Cook, "Rendering Antialiased Shadows with Depth Maps" (1987).
// Inputs:     shadow map with comparison sampler; ShadowReceiver; ShadowTile; BoxParameters: taps per side.
// Cost:       bilinear 1 fetch, four-tap 4, box N x N.
// Guarantees: [0, 1]; exactly 1 when no comparison fails, exactly 0 when all do.
// Use it:     bilinear and four-tap on the smallest devices. Not the box: TentPcf.hlsl covers more texels with fewer
//             fetches; it is included for comparison.
#ifndef PENUMBRA_FIXED_PCF_HLSL
#define PENUMBRA_FIXED_PCF_HLSL

#include "../Taps/CompareFetch.hlsl"
#include "../../Core/Penumbra.hlsl"
#include "Parameters/BoxParameters.hlsl"

float FilterBilinear(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver, ShadowTile tile)
{
    const CompareReceiver prepared = PrepareCompare(receiver, tile, float2(0.0, 0.0), 0.0);
    return SanitizeVisibility(CompareFetch(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared,
                                           prepared.centre));
}

float FourTapMean(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), CompareReceiver prepared)
{
    float sum = 0.0;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const float2 corner = float2((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5);
        sum += CompareFetch(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared, prepared.centre + corner);
    }
    return SanitizeVisibility(MeanVisibility(sum, 4.0));
}

float FilterFourTap(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver, ShadowTile tile)
{
    const CompareReceiver prepared = PrepareCompare(receiver, tile, float2(0.0, 0.0), 0.0);
    return FourTapMean(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared);
}

float FilterFourTapPlane(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver,
                         ShadowTile tile)
{
    const CompareReceiver prepared = PrepareCompare(receiver, tile, receiver.depthGradient, 0.0);
    return FourTapMean(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared);
}

float BoxMean(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), CompareReceiver prepared, int tapsPerSide)
{
    const int reach = (min(max(tapsPerSide, 1), 9) - 1) / 2;
    float sum = 0.0;
    UNITY_LOOP
    for (int y = -reach; y <= reach; ++y)
    {
        UNITY_LOOP
        for (int x = -reach; x <= reach; ++x)
        {
            sum += CompareFetch(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared,
                                prepared.centre + float2(x, y));
        }
    }
    const float side = 2.0 * float(reach) + 1.0;
    return SanitizeVisibility(MeanVisibility(sum, side * side));
}

float FilterBox(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver, ShadowTile tile,
                BoxParameters parameters)
{
    const CompareReceiver prepared = PrepareCompare(receiver, tile, float2(0.0, 0.0), 0.0);
    return BoxMean(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared, parameters.tapsPerSide);
}

float FilterBoxPlane(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver, ShadowTile tile,
                     BoxParameters parameters)
{
    const CompareReceiver prepared = PrepareCompare(receiver, tile, receiver.depthGradient, 0.0);
    return BoxMean(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), prepared, parameters.tapsPerSide);
}

#endif
