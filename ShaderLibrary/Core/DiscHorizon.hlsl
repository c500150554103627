// Penumbra: the share of a disc light above a straight edge.
//
// Computes:   DiscShareAbove  the share of a disc's area above a straight edge, as of a sun above a horizon
// Source:     the area of a circular segment: of a unit disc, with the edge at a distance x of the centre,
//             (acos x - x sqrt(1 - x^2)) / pi is cut off. With t = 1 - x that is t^(3/2) P(t), where P is smooth; P is
//             a polynomial of fourth degree that is 1/2 at t = 1, fitted with equal errors (Lawson's algorithm,
//             weighted least squares on 400 Chebyshev points).
// Inputs:     the edge's height over the disc's centre, in radii of the disc.
// Cost:       no fetches, one square root.
// Guarantees: [0, 1]; exactly 1 at -1 and below, exactly 1/2 at 0, exactly 0 at 1 and above; within 4e-7 of the exact
//             share; NaN is an edge below the disc.
// Use it:     where an occluder's edge is straight across the disc: horizons, large walls. Not: for bars narrower than
//             the disc.
#ifndef PENUMBRA_DISC_HORIZON_HLSL
#define PENUMBRA_DISC_HORIZON_HLSL

#include "FloatBits.hlsl"

float DiscShareAbove(float edge)
{
    const float height = BoundedOrLow(edge, -1.0, 1.0);
    const float t = 1.0 - abs(height);
    const float curve = -0.10018858 + t * (-0.01039478 + t * (-0.00149022 + t * -0.00129622));
    const float cut = t * sqrt(t) * (0.5 + (t - 1.0) * curve);
    return height > 0.0 ? cut : 1.0 - cut;
}

#endif
