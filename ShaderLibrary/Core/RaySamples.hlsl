// Penumbra: places along a view ray through fog.
//
// Computes:   FogShare        the share of a segment's length within which a given part of its fog's light is scattered
//             RaySampleShare  where, as a share of the length, one of `count` samples lies: in the middle of its part
//                             at a jitter of 0.5
// Source:     the law of Beer and Lambert. Of the light that homogeneous fog scatters to the eye, what comes from t
//             metres away weighs exp(-extinction t), so that the part u of it lies within t(u) = -ln(1 - u (1 -
//             exp(-d))) length / d, where d is the optical depth of the segment, extinction times length. Thin fog
//             uses its series, the cumulants of a Bernoulli variable, since the logarithm has no digits left there.
// Inputs:     part and jitter in [0, 1]; opticalDepth, 0 and up: 0 makes equal parts of the length; index from 0.
// Cost:       no fetches; an exponential and a logarithm in fog.
// Guarantees: [0, 1] for any input, rising with the index; NaN counts as 0. At most kMostRaySamples samples.
// Use it:     for shafts of light. The mean of a function at these places is its mean along the segment, weighted as
//             the fog weighs it. Not: for fog that is thicker in one place than in another: weight the samples there.
#ifndef PENUMBRA_RAY_SAMPLES_HLSL
#define PENUMBRA_RAY_SAMPLES_HLSL

#include "FloatBits.hlsl"

static const int kMostRaySamples = 64;
static const float kThinFog = 0.1;
static const float kOpaqueFog = 80.0; // exp(-80) is 0 beside 1

int BoundedRaySamples(int samples)
{
    return min(max(samples, 1), kMostRaySamples);
}

float FogShare(float part, float opticalDepth)
{
    const float u = BoundedOrLow(part, 0.0, 1.0);
    const float depth = BoundedOrLow(opticalDepth, 0.0, kOpaqueFog);
    if (depth < kThinFog)
    {
        const float spread = u * (1.0 - u);
        const float third = (1.0 - 2.0 * u) / 6.0 - depth * (1.0 - 6.0 * spread) / 24.0;
        return u - depth * spread * (0.5 - depth * third);
    }
    const float passes = (1.0 - u) + u * exp(-depth);
    return BoundedOrLow(-log(max(passes, 1e-37)) / depth, 0.0, 1.0);
}

float RaySampleShare(int index, int count, float jitter, float opticalDepth)
{
    const int bounded = BoundedRaySamples(count);
    const float within = float(min(max(index, 0), bounded - 1)) + BoundedOrLow(jitter, 0.0, 1.0);
    return FogShare(within / float(bounded), opticalDepth);
}

#endif
