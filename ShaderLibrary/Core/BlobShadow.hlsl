// Penumbra: the shadow of a ball that stands for an object.
//
// Computes:   BlobVisibility: the share of the sun that the ball leaves free, faded with its height, on what lies under
//             it
// Source:     SphereShadow.hlsl. Blob shadows have a rule besides: they fall on nothing above the ball's middle or
//             steeper than 60 degrees, so that an object is not darkened by the ball in it.
// Inputs:     receiver: position in metres, and the surface's normal, unit, of either sign; ball: centre and radius,
//             metres; towardSun: direction towards it, unit, and half its angular diameter in radians; fadeMetres: the
//             height of the ball's lowest point over the receiver at which no shadow is left; at 0 none fades. Up is
//             +Y, as in Unity.
// Cost:       no fetches; SphereVisibility where the ball is above.
// Guarantees: [0, 1] for any input; a normal of 0 is not known, and receives nothing.
// Use it:     for characters and props far away, multiplied over the balls. Overlapping shadows then count twice. Not:
//             on walls.
#ifndef PENUMBRA_BLOB_SHADOW_HLSL
#define PENUMBRA_BLOB_SHADOW_HLSL

#include "HeightFade.hlsl"
#include "SphereShadow.hlsl"

static const float kSteepestBlobReceiver = 0.5; // cosine of 60 degrees

float BlobVisibility(float3 receiver, float3 normal, float4 ball, float4 towardSun, float fadeMetres)
{
    const bool under = receiver.y < ball.y && abs(normal.y) > kSteepestBlobReceiver;
    if (!under) return 1.0;
    const float free = SphereVisibility(receiver, ball.xyz, ball.w, towardSun.xyz, towardSun.w);
    const float strength = HeightFade(ball.y - ball.w - receiver.y, fadeMetres);
    return min(max(1.0 - strength * (1.0 - free), 0.0), 1.0);
}

#endif
