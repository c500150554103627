// Penumbra: where far shadows take over from the cascades.
//
// Computes:   FarShare       how much of a receiver's visibility is that of far shadows
//             HandedOver     the visibility of both
// Source:     Candycat, "Graphics Study: RDR2, shadows" (2021): passes for what is nearer than about 200 m and for what
//             is farther. There the border is a depth; here it is a distance from the camera, as that of URP's fade,
//             and the last part before it is a mixture, so that no line is seen where both differ.
// Inputs:     distance of the receiver from the camera and the shadow distance, metres; border: the mixture's width, a
//             share of the shadow distance.
// Cost:       no fetches.
// Guarantees: [0, 1]; 0 up to the border, 1 from the shadow distance on; rises everywhere, with a continuous slope.
// Use it:     with cascades that draw all casters within their tiles, distant ones too: then they know more than far
//             shadows, which need not be read before the border.
#ifndef PENUMBRA_FAR_HAND_OVER_HLSL
#define PENUMBRA_FAR_HAND_OVER_HLSL

#include "FloatBits.hlsl"

float FarShare(float distance, float shadowDistance, float border)
{
    const float end = BoundedOrLow(shadowDistance, 0.0, 1e7);
    const float width = max(end * BoundedOrLow(border, 0.0, 1.0), 1e-6);
    // A distance that is not finite counts as far.
    const float t = 1.0 - BoundedOrLow((end - distance) / width, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

float HandedOver(float cascades, float far, float share)
{
    return min(max(cascades + share * (far - cascades), 0.0), 1.0);
}

#endif
