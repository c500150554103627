// Penumbra: moment shadow maps.
//
// Computes:   an upper bound of visibility from four moments of the depths around the receiver.
// Source:     Peters and Klein, "Moment Shadow Mapping", I3D 2015 (Core/HamburgerBound.hlsl).
// Inputs:     moments: of Map/FourMoments.hlsl, filtered over the map; ShadowReceiver; ShadowTile.
// Cost:       1 filtered fetch of four channels, and about 40 arithmetic operations.
// Guarantees: [0, 1]; 1 where nothing in the filtered area lies before the receiver; 0 where the bound is at most
//             `bleeding`.
// Use it:     for penumbrae of one width with less leaking than variance maps have, in 8 bytes per texel. Not: where
//             three or more occluders overlap in depth within the filter: light leaks there.
#ifndef PENUMBRA_MOMENT_SHADOWS_HLSL
#define PENUMBRA_MOMENT_SHADOWS_HLSL

#include "../../Platform/Platform.hlsl"
#include "Parameters/MomentShadowsParameters.hlsl"
#include "../../Core/HamburgerBound.hlsl"
#include "../../Core/MomentBounds.hlsl"
#include "../../Core/TileBounds.hlsl"
#include "../../Map/FourMoments.hlsl"

float FilterMoments(TEXTURE2D(moments), SAMPLER(sampler_moments), ShadowReceiver receiver, ShadowTile tile,
                    MomentShadowsParameters parameters)
{
    const float2 texels = ClampFootprint(TexelCoordinates(receiver.shadowCoord.xy, tile), BoundsInTexels(tile));
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    const float4 filtered = MomentsOf(SAMPLE_TEXTURE2D_LOD(moments, sampler_moments, texels / size, 0));
    const float depth = 2.0 * CentredDepth(SanitizeReceiverDepth(receiver.shadowCoord.z));
    const float mix = BoundedOrLow(parameters.mix, 1e-7, 0.1);
    // A share of up to `mix` of the mixed-in distribution may lie before a receiver before which nothing else lies;
    // rounding may add as much.
    const float bound = HamburgerBound(filtered, depth, mix) / (1.0 - 2.0 * mix);
    return SanitizeVisibility(ReduceBleeding(bound, BoundedOrLow(parameters.bleeding, 0.0, 0.95)));
}

#endif
