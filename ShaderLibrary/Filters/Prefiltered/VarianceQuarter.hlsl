// Penumbra: variance shadow maps at a quarter of the shadow map's resolution.
//
// Computes:   what Variance.hlsl computes, from means over 4 x 4 texels in place of a Gaussian.
// Source:     Donnelly and Lauritzen, "Variance Shadow Maps", I3D 2006; the size is that of the variance map in the
//             frames that SingleLoop.hlsl names, where it serves volumetric light.
// Inputs:     quarterMoments: of DepthRangePasses.hlsl; ShadowReceiver; ShadowTile of the shadow map.
// Cost:       1 filtered fetch, of a map with a sixteenth of the texels.
// Guarantees: those of Variance.hlsl.
// Use it:     where shadows may be coarse, as in fog. Not: for shadows on surfaces, where its texels show.
#ifndef PENUMBRA_VARIANCE_QUARTER_HLSL
#define PENUMBRA_VARIANCE_QUARTER_HLSL

#include "Variance.hlsl"
#include "../../Map/DepthRange.hlsl"

float FilterVarianceQuarter(TEXTURE2D(quarterMoments), SAMPLER(sampler_moments), ShadowReceiver receiver,
                            ShadowTile tile, VarianceParameters parameters)
{
    ShadowTile quarter = tile;
    quarter.atlasTexelSize = float4(tile.atlasTexelSize.xy * kRangeBlock, tile.atlasTexelSize.zw / kRangeBlock);
    return FilterVariance(TEXTURE2D_ARGS(quarterMoments, sampler_moments), receiver, quarter, parameters);
}

#endif
