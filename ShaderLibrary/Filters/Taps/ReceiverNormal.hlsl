// Penumbra: the receiver's normal as the light sees it.
//
// Computes:   the unit normal of the receiver's plane in light space, and the receiver moved off its surface.
// Source:     a plane whose height toward the light is h has the normal (-dh/dx, -dh/dy, 1), up to its length.
// Inputs:     QuadReceiver (stored depth per texel along the plane), ConeScales.
// Cost:       no fetches.
// Guarantees: finite; unit length, toward the light. Without a known plane, and without scales: straight to the light.
// Use it:     for biases along the normal, as some engines have them. Not: where casters are moved (ShadowBias.hlsl).
#ifndef PENUMBRA_RECEIVER_NORMAL_HLSL
#define PENUMBRA_RECEIVER_NORMAL_HLSL

#include "TexelQuad.hlsl"

// The rise of the receiver's plane toward the light, one texel further along x and y, stored depth.
float2 RisePerTexel(QuadReceiver receiver)
{
    return float2(DepthGap(receiver.gradient.x, 0.0), DepthGap(receiver.gradient.y, 0.0));
}

// The normal's xy lie across the light, along the texture's axes; its z points toward the light.
float3 ReceiverNormalLS(QuadReceiver receiver, ConeScales scales)
{
    const float metres = scales.depthPerMetre > 0.0 ? scales.texelsPerMetre / scales.depthPerMetre : 0.0;
    const float2 slope = min(max(RisePerTexel(receiver) * metres, -1e6), 1e6);
    return normalize(float3(-slope, 1.0));
}

// The receiver moved by `offset` metres in light space. It stays in the tile and between its depths.
QuadReceiver MoveReceiver(QuadReceiver receiver, float3 offset, ConeScales scales)
{
    QuadReceiver moved = receiver;
    moved.centre = min(max(receiver.centre + offset.xy * scales.texelsPerMetre, receiver.bounds.minimum),
                       receiver.bounds.maximum);
    moved.depth = min(max(MoveTowardLight(receiver.depth, offset.z * scales.depthPerMetre), 0.0), 1.0);
    return moved;
}

#endif
