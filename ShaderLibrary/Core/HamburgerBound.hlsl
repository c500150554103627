// Penumbra: bound of visibility from four moments of depth.
//
// Computes:   the largest share of a distribution of depths that can lie at or behind a depth, when only its first four
//             moments are known: 1 less the weights, nearer to the light than the depth, of the one distribution of
//             three depths that has these moments and the depth itself (its canonical representation).
// Source:     Peters and Klein, "Moment Shadow Mapping", I3D 2015 (Hamburger moment problem). The weights are written
//             as 1 / K(x, x), K the kernel b(x)^T B^-1 b(x) of the Hankel matrix B: a sum of squares, which
//             cannot cancel. Smallest pivots and the distribution that moments are mixed with: there, section 3.
// Inputs:     moments: means of z, z^2, z^3, z^4 of depths z in [-1, 1]; depth: of the receiver, there; mix: share of
//             (0, 3/8, 0, 3/8) that replaces the moments', against rounding.
// Cost:       no fetches.
// Guarantees: [0, 1] and finite for finite inputs. Exact for up to three depths of which one is the receiver's.
// Use it:     with moments that were filtered. Not: with raw depths, for which a comparison is exact.
#ifndef PENUMBRA_HAMBURGER_BOUND_HLSL
#define PENUMBRA_HAMBURGER_BOUND_HLSL

static const float kSmallestPivot = 1e-10;
static const float kLargestRoot = 1e3; // a depth there has no weight

// The Hankel matrix ((1, b1, b2), (b1, b2, b3), (b2, b3, b4)) = L D L^T.
struct HankelFactors
{
    float2 moments; // b1, b2: the first column of L below its 1
    float lower;    // L's third row, second column
    float2 pivots;  // second and third entry of D; the first is 1
};

HankelFactors FactorHankel(float4 moments)
{
    HankelFactors factors;
    factors.moments = moments.xy;
    factors.pivots.x = max(moments.y - moments.x * moments.x, kSmallestPivot);
    factors.lower = (moments.z - moments.x * moments.y) / factors.pivots.x;
    const float rest = moments.w - moments.y * moments.y - factors.lower * factors.lower * factors.pivots.x;
    factors.pivots.y = max(rest, kSmallestPivot);
    return factors;
}

// L^-1 (1, x, x^2), without its 1.
float2 ReducedPowers(HankelFactors factors, float x)
{
    const float y = x - factors.moments.x;
    return float2(y, x * x - factors.moments.y - factors.lower * y);
}

// Weight of the depth x in the distribution that contains it.
float CanonicalWeight(HankelFactors factors, float x)
{
    const float2 y = ReducedPowers(factors, x);
    return 1.0 / (1.0 + y.x * y.x / factors.pivots.x + y.y * y.y / factors.pivots.y);
}

float4 MixedMoments(float4 moments, float mix)
{
    return moments + mix * (float4(0.0, 0.375, 0.0, 0.375) - moments);
}

// The other two depths of the distribution that contains `depth`: B c = (1, depth, depth^2), and they are the roots of
// c.x + c.y x + c.z x^2.
float2 CanonicalDepths(HankelFactors factors, float depth)
{
    const float2 y = ReducedPowers(factors, depth);
    float3 c;
    c.z = y.y / factors.pivots.y;
    c.y = y.x / factors.pivots.x - factors.lower * c.z;
    c.x = 1.0 - factors.moments.x * c.y - factors.moments.y * c.z;
    const float discriminant = sqrt(max(c.y * c.y - 4.0 * c.z * c.x, 0.0));
    const float q = -0.5 * (c.y + (c.y < 0.0 ? -discriminant : discriminant)); // no cancellation
    return float2(abs(q) < kLargestRoot * abs(c.z) ? q / c.z : kLargestRoot,
                  abs(c.x) < kLargestRoot * abs(q) ? c.x / q : kLargestRoot);
}

float HamburgerBound(float4 moments, float depth, float mix)
{
    const HankelFactors factors = FactorHankel(MixedMoments(moments, mix));
    const float2 others = CanonicalDepths(factors, depth);
    const float nearer = (others.x < depth ? CanonicalWeight(factors, others.x) : 0.0) +
                         (others.y < depth ? CanonicalWeight(factors, others.y) : 0.0);
    return min(max(1.0 - nearer, 0.0), 1.0);
}

#endif
