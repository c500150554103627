// Penumbra: bounds of visibility from moments of depth.
//
// Computes:   the largest share of a distribution of depths that can lie at or behind a depth, when only its mean and
//             its mean square are known: Cantelli's one-sided form of Chebyshev's inequality.
// Source:     Donnelly and Lauritzen, "Variance Shadow Maps", I3D 2006, equation 5; reduction of light bleeding:
//             Lauritzen, GPU Gems 3, section 8.4.3.
// Inputs:     moments: mean and mean square of depths, of any unit; depth: in that unit, larger farther from the
//             light; smallestVariance: > 0, in that unit squared.
// Cost:       no fetches.
// Guarantees: [0, 1] for finite inputs, and 1 at and before the mean. Exact for two depths, the farther of which is
//             the receiver's.
// Use it:     with moments that were filtered. Not: with raw depths, for which a comparison is exact.
#ifndef PENUMBRA_MOMENT_BOUNDS_HLSL
#define PENUMBRA_MOMENT_BOUNDS_HLSL

float ChebyshevBound(float2 moments, float depth, float smallestVariance)
{
    const float variance = max(moments.y - moments.x * moments.x, smallestVariance);
    const float behind = depth - moments.x;
    return behind > 0.0 ? variance / (variance + behind * behind) : 1.0;
}

// Bounds up to `amount`, in [0, 1), become dark, and the rest is stretched to [0, 1]. The light that leaks where two
// occluders overlap is below that amount, and so are the outer parts of penumbrae.
float ReduceBleeding(float bound, float amount)
{
    return min(max((bound - amount) / (1.0 - amount), 0.0), 1.0);
}

#endif
