// Penumbra: exponential shadow maps in logarithmic space.
//
// Computes:   what Exponential.hlsl computes, from a map of log(mean of exp(c z)) / c: a depth, which no exponent lets
//             overflow and 16 bits store evenly.
// Source:     Salvi, "Rendering Filtered Shadows with Exponential Shadow Maps", ShaderX 6, 2008.
// Inputs:     softDepths: the map, point sampled; ShadowReceiver; ShadowTile.
// Cost:       1 gather: a bilinear sampler would interpolate logarithms. Each texel counts for at most 1 before the
//             four are interpolated.
// Guarantees: [0, 1]; 1 where nothing in the filtered area lies before the receiver; 0 where the mean is at most
//             `bleeding`.
// Use it:     in place of Exponential.hlsl where its largest exponent is not enough, or with 16 bits. Not: at contacts,
//             for the same reason, but the gap that fades is smaller as the exponent is larger.
#ifndef PENUMBRA_LOG_EXPONENTIAL_HLSL
#define PENUMBRA_LOG_EXPONENTIAL_HLSL

#include "../../Platform/Platform.hlsl"
#include "Parameters/LogExponentialParameters.hlsl"
#include "../Taps/TexelQuad.hlsl"
#include "../../Core/MomentBounds.hlsl"
#include "../../Map/DepthMoments.hlsl"

float FilterLogExponential(TEXTURE2D(softDepths), SAMPLER(sampler_softDepths), ShadowReceiver receiver, ShadowTile tile,
                           LogExponentialParameters parameters)
{
    const float2 texels = TexelCoordinates(receiver.shadowCoord.xy, tile);
    const float2 corner = ClampQuadCorner(texels, BoundsInTexels(tile));
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    const float4 stored = GATHER_RED_TEXTURE2D(softDepths, sampler_softDepths, corner / size);
    const float exponent = BoundedOrLow(parameters.exponent, 1.0, 1000.0);
    const float depth = CentredDepth(SanitizeReceiverDepth(receiver.shadowCoord.z));
    const float4 dark = 1.0 - exp(min(exponent * (stored - 0.5 - depth), 0.0));
    const float visibility = 1.0 - dot(dark, BilinearWeights(texels, corner));
    return SanitizeVisibility(ReduceBleeding(visibility, BoundedOrLow(parameters.bleeding, 0.0, 0.95)));
}

#endif
