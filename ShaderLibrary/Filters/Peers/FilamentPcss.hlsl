// Penumbra: PCSS by the rules of Filament, for comparison.
//
// Computes:   the mean depth of blockers on a disk as wide as Filament's bulb, then the lit share of that disk scaled
//             by the penumbra ratio.
// Source:     Filament's ShadowType PCSS (FilamentTaps.hlsl): 16 taps for the search and 16 for the filter, each of
//             them a bilinear comparison of four texels. Newer versions filter variance maps instead.
// Inputs:     shadow map (raw reads; the comparison sampler is not used), point sampler; ShadowReceiver; ShadowTile;
//             FilamentParameters.
// Cost:       blockerSamples fetches where nothing blocks, else blockerSamples + filterSamples.
// Guarantees: [0, 1] for any input; exactly 1 without blockers; exactly 0 below a wall that is above the receiver's
//             plane at every tap (the plane of a surface along the light's rays passes the near plane); texels outside
//             the tile are not read.
// Use it:     for comparison with Filament, whose parameters FilamentTaps.hlsl explains; the renderer feature does not
//             offer it. Not: as a first choice.
#ifndef PENUMBRA_FILAMENT_PCSS_HLSL
#define PENUMBRA_FILAMENT_PCSS_HLSL

#include "FilamentTaps.hlsl"

// The lit share of the four texels around `texels`, each compared with the receiver's plane at the tap, `plane` above
// it.
float FilamentLit(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, float2 texels, float plane)
{
    const float2 inside = ClampToTile(texels, receiver.bounds);
    const float2 corner = ClampQuadCorner(inside, receiver.bounds);
    const float4 mapDepth = SanitizeMapDepth(GATHER_RED_TEXTURE2D(shadowMap, sampler_point,
                                                                  corner * receiver.texelSize));
    const float depth = receiver.depth;
    const float4 gap = DepthGap(mapDepth, float4(depth, depth, depth, depth)) - plane;
    const float4 blocking = float4(gap.x >= 0.0, gap.y >= 0.0, gap.z >= 0.0, gap.w >= 0.0);
    const float4 weight = BilinearWeights(inside, corner);
    return LitShare(dot(weight, 1.0 - blocking), dot(weight, blocking));
}

float FilterFilamentPcss(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                         ShadowReceiver receiver, ShadowTile tile, FilamentParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const QuadReceiver prepared = FilamentReceiver(receiver, tile, scales, parameters);
    const float2 rotation = UnitRotation(receiver.rotation);
    const float bulb = FilamentBulbRadius(scales, parameters);
    const FilamentBlockers blockers = FilamentSearch(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, rotation, bulb,
                                                     FilamentCount(parameters.blockerSamples));
    if (!(blockers.heightSum > 0.0)) return 1.0;

    const float ratio = FilamentPenumbraRatio(prepared, blockers.heightSum / blockers.count);
    const float radius = min(max(bulb * ratio, -scales.largestRadius), scales.largestRadius);
    const int count = FilamentCount(parameters.filterSamples);
    float lit = 0.0;
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        const float2 offset = RotateDisk(FilamentTap(i, count), rotation) * radius;
        const float plane = dot(RisePerTexel(prepared), offset);
        lit += FilamentLit(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, prepared.centre + offset, plane);
    }
    return SanitizeVisibility(MeanVisibility(lit, float(count)));
}

#endif
