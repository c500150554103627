// Penumbra: one bilinear comparison, inside its tile.
//
// Computes:   the share of the four nearest texels, by bilinear weight, that do not block the receiver.
// Source:     percentage-closer filtering, Reeves, Salesin and Cook (1987), as hardware implements it.
// Inputs:     texels: texel coordinates of the sample; CompareReceiver. Sampler: linear, clamp, comparing LESS_EQUAL
//             (reversed Z: GREATER_EQUAL) the reference with the texel.
// Cost:       1 fetch.
// Guarantees: in [0, 1]; reads no texel outside the tile. How a NaN texel compares depends on the device.
// Use it:     as the building block of fixed kernels. Not: mixed with raw reads of the same map in one function:
//             compilers that separate comparison textures from others (glslang) cannot pass one that is both.
#ifndef PENUMBRA_COMPARE_FETCH_HLSL
#define PENUMBRA_COMPARE_FETCH_HLSL

#include "../../Platform/Platform.hlsl"
#include "../../Core/DepthConvention.hlsl"
#include "../../Core/FloatBits.hlsl"
#include "../../Core/ShadowStructs.hlsl"
#include "../../Core/TileBounds.hlsl"
#include "../../Core/ReceiverPlane.hlsl"

struct CompareReceiver
{
    TileBounds bounds;
    float2 texelSize; // atlas UV
    float2 centre;    // texel coordinates
    float depth;
    float2 gradient;  // stored depth per texel
    bool atNearPlane; // no texel of the map can lie in front of the receiver
};

// gradient is stored depth per atlas UV, 0 for a flat comparison. bias is stored depth toward the light.
CompareReceiver PrepareCompare(ShadowReceiver receiver, ShadowTile tile, float2 gradient, float bias)
{
    CompareReceiver prepared;
    prepared.bounds = BoundsInTexels(tile);
    prepared.texelSize = 1.0 / max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    prepared.centre = TexelCoordinates(receiver.shadowCoord.xy, tile);
    const float depth = SanitizeReceiverDepth(receiver.shadowCoord.z);
    prepared.atNearPlane = !(LargestGap(depth) > 0.0);
    prepared.depth = min(max(MoveTowardLight(depth, bias), 0.0), 1.0);
    prepared.gradient = BoundGradient(gradient) * prepared.texelSize;
    return prepared;
}

float CompareFetch(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), CompareReceiver receiver, float2 texels)
{
    const float2 inside = ClampFootprint(texels, receiver.bounds);
    const float onPlane = ReceiverPlaneDepth(receiver.depth, receiver.gradient, inside - receiver.centre);
    const float reference = receiver.atNearPlane ? kNearestDepth : KeepBehindNearPlane(onPlane);
    const float3 coordinate = float3(inside * receiver.texelSize, reference);
    return SAMPLE_TEXTURE2D_SHADOW(shadowMap, sampler_shadowMap, coordinate);
}

#endif
