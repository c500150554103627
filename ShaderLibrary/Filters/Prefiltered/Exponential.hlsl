// Penumbra: exponential shadow maps.
//
// Computes:   the mean of exp(c (z - r)) over the depths z of the filtered area and the receiver's depth r, at most 1.
// Source:     Annen, Mertens, Seidel, Flerackers and Kautz, "Exponential Shadow Maps", GI 2008, equation 5.
// Inputs:     exponentials: means of exp(c z), of Map/DepthWarp.hlsl; ShadowReceiver; ShadowTile.
// Cost:       1 filtered fetch.
// Guarantees: [0, 1]; 1 where nothing in the filtered area lies before the receiver; 0 where the mean is at most
//             `bleeding`.
// Use it:     for penumbrae of one width where occluders overlap in depth: unlike variance maps it does not leak there.
//             Not: at contacts. A gap g between occluder and receiver leaves exp(-c g) of the light, so shadows fade
//             towards their casters, the more the larger the map's range of depths is.
#ifndef PENUMBRA_EXPONENTIAL_HLSL
#define PENUMBRA_EXPONENTIAL_HLSL

#include "../../Platform/Platform.hlsl"
#include "Parameters/ExponentialParameters.hlsl"
#include "../../Core/MomentBounds.hlsl"
#include "../../Core/TileBounds.hlsl"
#include "../../Map/DepthWarp.hlsl"

float FilterExponential(TEXTURE2D(exponentials), SAMPLER(sampler_exponentials), ShadowReceiver receiver,
                        ShadowTile tile, ExponentialParameters parameters)
{
    const float2 texels = ClampFootprint(TexelCoordinates(receiver.shadowCoord.xy, tile), BoundsInTexels(tile));
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    const float mean = SAMPLE_TEXTURE2D_LOD(exponentials, sampler_exponentials, texels / size, 0).x;
    const float exponent = BoundedOrLow(parameters.exponent, 1.0, kLargestExponent);
    const float depth = CentredDepth(SanitizeReceiverDepth(receiver.shadowCoord.z));
    const float visibility = min(mean * exp(-exponent * depth), 1.0);
    return SanitizeVisibility(ReduceBleeding(visibility, BoundedOrLow(parameters.bleeding, 0.0, 0.95)));
}

#endif
