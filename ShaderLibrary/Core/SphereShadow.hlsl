// Penumbra: the shadow of a sphere under a disc light.
//
// Computes:   DiscShareBesideDisc  the share of a disc that another leaves free
//             SphereVisibility     the share of the sun that a sphere leaves free
// Source:     the area of the lens of two circles. Seen from the receiver both discs are small, so that their angles
//             are lengths in a plane. What engines call a blob shadow is a round picture under an object; this is the
//             round shadow that the object would have if it were a ball.
// Inputs:     angles in radians; positions in metres; the direction towards the sun, of unit length.
// Cost:       no fetches; two arc tangents and two sines where both discs overlap in part.
// Guarantees: [0, 1] for any input; 0 inside of the sphere; what is behind the receiver casts nothing.
// Use it:     for characters and props far away, a sphere or a few each. Not: for shapes that are no balls, seen near.
#ifndef PENUMBRA_SPHERE_SHADOW_HLSL
#define PENUMBRA_SPHERE_SHADOW_HLSL

#include "FloatBits.hlsl"

// The area that a chord, at this distance from the centre and of this half length, cuts off a circle: r^2 (a - sin a
// cos a), where a is half the angle over the chord. Small angles use the series, since their difference has no digits
// left.
float CircularSegment(float radius, float chord, float halfLength)
{
    const float angle = atan2(halfLength, chord);
    const float square = angle * angle;
    const float series =
        angle * square * (0.66666667 - square * (0.13333333 - square * (0.012698413 - square * 0.00070546737)));
    const float difference = angle < 0.5 ? series : angle - sin(angle) * cos(angle);
    return radius * radius * difference;
}

// light and blocker are radii; apart is the distance of the centres.
float DiscShareBesideDisc(float light, float blocker, float apart)
{
    const float disc = BoundedOrLow(light, 1e-6, 10.0);
    const float other = BoundedOrLow(blocker, 0.0, 10.0);
    const float distance = BoundedOrLow(apart, 0.0, 10.0);
    if (distance >= disc + other) return 1.0;
    if (distance <= abs(disc - other)) return other >= disc ? 0.0 : 1.0 - (other * other) / (disc * disc);
    // The distance from the light's centre to the chord through both points where the circles meet.
    const float chord = (distance * distance + (disc - other) * (disc + other)) / (2.0 * distance);
    const float halfLength = sqrt(max((disc - chord) * (disc + chord), 0.0));
    const float lens = CircularSegment(disc, chord, halfLength) + CircularSegment(other, distance - chord, halfLength);
    return min(max(1.0 - lens / (3.14159265 * disc * disc), 0.0), 1.0);
}

float SphereVisibility(float3 receiver, float3 centre, float radius, float3 towardSun, float halfDiameter)
{
    const float3 towards = centre - receiver;
    const float squared = dot(towards, towards);
    const float size = BoundedOrLow(radius, 0.0, 1e6);
    if (!HasFiniteBits(squared)) return 1.0;
    if (squared <= size * size) return 0.0;
    const float distance = sqrt(squared);
    const float along = dot(towards, towardSun);
    const float3 side = towards - along * towardSun;
    // The arc tangent serves here because the arc cosine has no digits for small angles.
    const float apart = atan2(sqrt(dot(side, side)), along);
    if (!(along > -size)) return 1.0;
    return DiscShareBesideDisc(halfDiameter, asin(min(size / distance, 1.0)), apart);
}

#endif
