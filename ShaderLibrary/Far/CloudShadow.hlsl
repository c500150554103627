// Penumbra: shadows of a cloud layer.
//
// Computes:   CloudVisibility  how much of the sun's light passes the clouds between it and a receiver
// Source:     as Core/CloudLayer.hlsl; the map holds the transmittance of the layer straight up, which is raised to the
//             power of the way through it: Beer and Lambert.
// Inputs:     transmittance: one channel, 1 where there is no cloud, over the layer's area, its first texel at the
//             smallest x and z; layer: BoundedCloudLayer, or CloudLayerAround for a map that follows the camera
//             (Core/CloudLayer.hlsl); the receiver and the direction towards the sun, world space, the latter of unit
//             length.
// Cost:       1 filtered fetch.
// Guarantees: [0, 1] for any input; 1 beside the map and over the layer.
// Use it:     for broad clouds over a landscape; multiply with the shadows of the ground. Not: for their penumbrae,
//             which are wide (15 m for a layer at 1,600 m): blur the map instead.
#ifndef PENUMBRA_CLOUD_SHADOW_HLSL
#define PENUMBRA_CLOUD_SHADOW_HLSL

#include "../Platform/Platform.hlsl"
#include "../Core/CloudLayer.hlsl"

float CloudVisibility(TEXTURE2D(transmittance), SAMPLER(sampler_linear), float3 positionWS, float3 towardSun,
                      CloudLayer layer)
{
    const float weight = CloudWeight(positionWS, towardSun, layer);
    if (weight <= 0.0) return 1.0;
    const float2 uv = CloudUv(positionWS, towardSun, layer);
    const float stored = SAMPLE_TEXTURE2D_LOD(transmittance, sampler_linear, uv, 0.0).r;
    const float straight = BoundedOrLow(stored, 0.0, 1.0);
    const float slanted = straight > 0.0 ? pow(straight, min(1.0 / max(towardSun.y, 1e-3), 1e3)) : 0.0;
    return min(max(1.0 + weight * (slanted - 1.0), 0.0), 1.0);
}

#endif
