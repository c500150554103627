// Penumbra: the mean blocker from moments of depth.
//
// Computes:   the share of a distribution of depths that blocks a receiver, and that share times the blockers' mean
//             gap; from two moments, or from four.
// Source:     two: Yang, Dong, Feng, Seidel, Kautz, "Variance Soft Shadow Mapping", Pacific Graphics 2010, equation 6:
//             z_b = (z_avg - p z_r) / (1 - p), with Chebyshev's p, where all that does not block lies at the receiver.
//             Hence (1 - p) (z_r - z_b) = z_r - z_avg, which needs no division.
//             Four: Peters, Muenstermann, Wetzstein, Klein, "Improved Moment Shadow Maps for Translucent Occluders,
//             Soft Shadows and Single Scattering", JCGT 2017: the mean of the depths nearer than the receiver in the
//             distribution of three depths that has these moments and the receiver's depth.
// Inputs:     moments, depth, smallestVariance, mix: those of MomentBounds.hlsl and HamburgerBound.hlsl.
// Cost:       no fetches.
// Guarantees: finite and >= 0 for finite inputs. Two moments are exact for one blocker's depth before the receiver's,
//             four for two.
// Use it:     with moments of the area in which blockers are searched. Not: with raw depths, whose mean is exact.
#ifndef PENUMBRA_BLOCKER_MEAN_HLSL
#define PENUMBRA_BLOCKER_MEAN_HLSL

#include "HamburgerBound.hlsl"
#include "MomentBounds.hlsl"

struct BlockerShare
{
    float share;  // lower bound of the share of the area that blocks
    float gapSum; // that share times the blockers' mean gap
};

BlockerShare BlockersOfVariance(float2 moments, float depth, float smallestVariance)
{
    const float gap = depth - moments.x;
    BlockerShare blockers;
    blockers.share = 1.0 - ChebyshevBound(moments, depth, smallestVariance);
    blockers.gapSum = gap > 0.0 ? gap : 0.0;
    return blockers;
}

// The largest share that can lie before the receiver although the mean lies behind it.
float LargestBlockedShare(float2 moments, float depth, float smallestVariance)
{
    return ChebyshevBound(float2(-moments.x, moments.y), -depth, smallestVariance);
}

BlockerShare BlockersOfMoments(float4 moments, float depth, float mix)
{
    const HankelFactors factors = FactorHankel(MixedMoments(moments, mix));
    const float2 others = CanonicalDepths(factors, depth);
    const float first = others.x < depth ? CanonicalWeight(factors, others.x) : 0.0;
    const float second = others.y < depth ? CanonicalWeight(factors, others.y) : 0.0;
    BlockerShare blockers;
    blockers.share = min(first + second, 1.0);
    // A root before -1 is outside the map: its weight is only rounding error.
    blockers.gapSum = first * (depth - max(others.x, -1.0)) + second * (depth - max(others.y, -1.0));
    blockers.gapSum = max(blockers.gapSum, 0.0);
    return blockers;
}

#endif
