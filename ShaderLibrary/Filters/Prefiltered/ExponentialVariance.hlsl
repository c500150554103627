// Penumbra: exponential variance shadow maps.
//
// Computes:   the smaller of two upper bounds of visibility: Chebyshev's for exp(c z) and for -exp(-d z) of the depths
//             z around the receiver.
// Source:     Lauritzen and McCool, "Layered Variance Shadow Maps", GI 2008, section 7.
// Inputs:     moments: of Map/DepthWarp.hlsl, filtered over the map; ShadowReceiver; ShadowTile.
// Cost:       1 filtered fetch of four channels.
// Guarantees: [0, 1]; 1 where nothing in the filtered area lies before the receiver; 0 where the bound is at most
//             `bleeding`. The smallest variances are those which rounding alone can leave: kRoundings roundings of the
//             mean square in the map's format, which for exponentials are relative to it.
// Use it:     as variance maps, with less leaking where occluders overlap. Not: with 16 bits where that matters: the
//             exponents that fit are small.
#ifndef PENUMBRA_EXPONENTIAL_VARIANCE_HLSL
#define PENUMBRA_EXPONENTIAL_VARIANCE_HLSL

#include "../../Platform/Platform.hlsl"
#include "Parameters/ExponentialVarianceParameters.hlsl"
#include "../../Core/MomentBounds.hlsl"
#include "../../Core/TileBounds.hlsl"
#include "../../Map/DepthWarp.hlsl"

float FilterExponentialVariance(TEXTURE2D(moments), SAMPLER(sampler_moments), ShadowReceiver receiver, ShadowTile tile,
                                ExponentialVarianceParameters parameters)
{
    const float2 texels = ClampFootprint(TexelCoordinates(receiver.shadowCoord.xy, tile), BoundsInTexels(tile));
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    const float4 filtered = SAMPLE_TEXTURE2D_LOD(moments, sampler_moments, texels / size, 0);
    const float2 exponents = float2(BoundedOrLow(parameters.positiveExponent, 1.0, kLargestSquaredExponent),
                                    BoundedOrLow(parameters.negativeExponent, 1.0, kLargestSquaredExponent));
    const float2 warped = WarpedDepth(CentredDepth(SanitizeReceiverDepth(receiver.shadowCoord.z)), exponents);
    const float precision = BoundedOrLow(parameters.precision, 5.9604645e-8, 1e-2);
    const float2 smallest = kRoundings * precision * filtered.zw;
    const float bound = min(ChebyshevBound(filtered.xz, warped.x, smallest.x),
                            ChebyshevBound(filtered.yw, warped.y, smallest.y));
    return SanitizeVisibility(ReduceBleeding(bound, BoundedOrLow(parameters.bleeding, 0.0, 0.95)));
}

#endif
