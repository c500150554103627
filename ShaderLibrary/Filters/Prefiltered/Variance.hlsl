// Penumbra: variance shadow maps.
//
// Computes:   an upper bound of visibility from the mean and the mean square of the depths around the receiver.
// Source:     Donnelly and Lauritzen, "Variance Shadow Maps", I3D 2006 (Core/MomentBounds.hlsl).
// Inputs:     moments: of Map/DepthMoments.hlsl, filtered over the map; ShadowReceiver; ShadowTile.
// Cost:       1 filtered fetch.
// Guarantees: [0, 1]; 1 where nothing in the filtered area lies before the receiver; 0 where the bound is at most
//             `bleeding`. The smallest variance is that which rounding alone can leave: kRoundings roundings of the
//             mean square in the map's format.
// Use it:     for penumbrae of one width, at the cost of one fetch for any width. Not: where occluders overlap in
//             depth, as foliage does: light leaks between them.
#ifndef PENUMBRA_VARIANCE_HLSL
#define PENUMBRA_VARIANCE_HLSL

#include "Parameters/VarianceParameters.hlsl"
#include "../../Core/MomentBounds.hlsl"
#include "../../Core/TileBounds.hlsl"
#include "../../Map/DepthMoments.hlsl"

// Rounding is relative to the mean square, and no finer than the format near 0.
float RoundingVariance(float meanSquare, float precision)
{
    return kRoundings * precision * max(meanSquare, precision);
}

float FilterVariance(TEXTURE2D(moments), SAMPLER(sampler_moments), ShadowReceiver receiver, ShadowTile tile,
                     VarianceParameters parameters)
{
    const float2 texels = ClampFootprint(TexelCoordinates(receiver.shadowCoord.xy, tile), BoundsInTexels(tile));
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    const float2 filtered = SAMPLE_TEXTURE2D_LOD(moments, sampler_moments, texels / size, 0).xy;
    const float depth = CentredDepth(SanitizeReceiverDepth(receiver.shadowCoord.z));
    const float precision = BoundedOrLow(parameters.precision, 5.9604645e-8, 1e-2);
    const float bound = ChebyshevBound(filtered, depth, RoundingVariance(filtered.y, precision));
    return SanitizeVisibility(ReduceBleeding(bound, BoundedOrLow(parameters.bleeding, 0.0, 0.95)));
}

#endif
