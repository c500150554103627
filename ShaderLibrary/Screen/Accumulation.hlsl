// Penumbra: the mean of the visibility over frames, with reprojection and rejection.
//
// Computes:   the exponential mean of a pixel's visibility and of what the same place had in the frames before.
// Source:     Yang, Liu and Salvi, "A Survey of Temporal Antialiasing Techniques" (2020): reprojection, rejection by
//             depth, clipping to the mean and deviation of the pixels around.
// Inputs:     visibility of a pixel and of the eight around it at AccumulationOffset(); words of PackAccumulated() of
//             the frame before, of the four pixels around the place where the surface was seen then.
// Cost:       no fetches.
// Guarantees: [0, 1]. Without history, and where all pixels around are equal, the visibility stays to the last bit.
// Use it:     where noise is new in every frame. Not: with static noise, which is the same in the mean.
#ifndef PENUMBRA_ACCUMULATION_HLSL
#define PENUMBRA_ACCUMULATION_HLSL

#include "../Core/FloatBits.hlsl"

#define ACCUMULATION_TAPS 8

// The mean is that of about this many frames; a word holds up to 15.
static const float kAccumulatedFrames = 8.0;
// History is clipped to so many deviations of the pixels around from their mean.
static const float kAccumulationDeviations = 1.5;
// Up to the first deviation of the pixels around from a plane, noise alone is assumed; from the second on, edges of
// shadows, which history from between pixels would blur.
static const float kAccumulationNoise = 0.04;
static const float kAccumulationEdges = 0.12;
// The share of its depth by which a surface may lie elsewhere than expected, beside its own slope.
static const float kAccumulationDepth = 0.02;
// Depth as a word holds it: half precision has the same share of all distances if the far plane is 0.
static const float kAccumulatedDepthScale = 32768.0;

float DepthFromFarPlane(float storedDepth)
{
    return abs(storedDepth - kFarthestDepth);
}

struct Accumulated
{
    float visibility;
    float frames; // whole, 0 to 15; 0 where there is no history
    float depth;  // DepthFromFarPlane()
};

// Bits 0 to 11 are the visibility, 12 to 15 the frames, 16 to 31 the depth.
uint PackAccumulated(Accumulated value)
{
    return uint(value.visibility * 4095.0 + 0.5) | (uint(value.frames) << 12) |
           (f32tof16(value.depth * kAccumulatedDepthScale) << 16);
}

Accumulated UnpackAccumulated(uint word)
{
    Accumulated value;
    value.visibility = float(word & 0xfffu) / 4095.0;
    value.frames = float((word >> 12) & 0xfu);
    value.depth = f16tof32(word >> 16) / kAccumulatedDepthScale;
    return value;
}

// The pixels that are read beside the own one.
int2 AccumulationOffset(int index)
{
    const int place = index < 4 ? index : index + 1;
    return int2(2 * (place % 3 - 1), 2 * (place / 3 - 1));
}

// What lies around a pixel in this frame.
struct AccumulationSurrounds
{
    float2 limits;   // of history: least and greatest
    float deviation; // of the pixels from a plane through them: noise and edges
    bool isUniform;  // all pixels are equal
};

AccumulationSurrounds SurroundsOf(float here, float around[ACCUMULATION_TAPS])
{
    float sum = here;
    float squares = here * here;
    float2 slope = float2(0.0, 0.0);
    float2 extremes = float2(here, here);
    UNITY_UNROLL
    for (int i = 0; i < ACCUMULATION_TAPS; ++i)
    {
        sum += around[i];
        squares += around[i] * around[i];
        slope += around[i] * (0.5 / 6.0) * float2(AccumulationOffset(i));
        extremes = float2(min(extremes.x, around[i]), max(extremes.y, around[i]));
    }
    const float mean = sum / float(ACCUMULATION_TAPS + 1);
    const float variance = max(squares / float(ACCUMULATION_TAPS + 1) - mean * mean, 0.0);
    AccumulationSurrounds result;
    result.deviation = sqrt(max(variance - dot(slope, slope) * 6.0 / float(ACCUMULATION_TAPS + 1), 0.0));
    // A thin shadow differs from all around it, so the pixel's own visibility is within the limits, too.
    const float reach = kAccumulationDeviations * sqrt(variance);
    result.limits = float2(min(mean - reach, here), max(mean + reach, here));
    result.isUniform = extremes.x == extremes.y;
    return result;
}

struct AccumulationHistory
{
    float visibility;
    float frames; // 0 where the surface was not seen
    float blur;   // 0 at a pixel, 1 in the middle between pixels
};

// History of a place between four pixels, rows after each other; `share` is its place between them. `expected` is the
// depth that the surface had then, and `slope` how much that changes within a pixel. Pixels of other surfaces, or
// without history, do not count.
AccumulationHistory HistoryBetween(uint words[4], float2 share, float expected, float slope)
{
    const float tolerance = kAccumulationDepth * expected + min(slope, 4.0 * kAccumulationDepth * expected);
    float2 sums = float2(0.0, 0.0); // x: visibility, y: frames
    float weights = 0.0;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const Accumulated tap = UnpackAccumulated(words[i]);
        const float2 beside = float2((i & 1) == 0 ? 1.0 - share.x : share.x, i < 2 ? 1.0 - share.y : share.y);
        const bool fits = tap.frames > 0.0 && abs(tap.depth - expected) <= tolerance;
        const float weight = fits ? beside.x * beside.y : 0.0;
        sums += weight * float2(tap.visibility, tap.frames);
        weights += weight;
    }
    const bool known = weights > 0.1; // a sliver of a pixel says little of the place
    const float2 between = 4.0 * share * (1.0 - share);
    AccumulationHistory history;
    history.visibility = known ? sums.x / weights : 0.0;
    history.frames = known ? sums.y / weights : 0.0;
    history.blur = min(3.0 * max(between.x, between.y), 1.0);
    return history;
}

// The mean of this frame and of history.
Accumulated AccumulateFrame(float here, float depth, AccumulationHistory history, AccumulationSurrounds surrounds)
{
    const float edges =
        (surrounds.deviation - kAccumulationNoise) / (kAccumulationEdges - kAccumulationNoise);
    const float trusted = kAccumulatedFrames * (1.0 - history.blur * min(max(edges, 0.0), 1.0));
    const float limited = min(max(history.visibility, surrounds.limits.x), surrounds.limits.y);
    Accumulated result;
    result.frames = min(floor(min(history.frames, trusted) + 1.5), kAccumulatedFrames);
    result.visibility = here + (limited - here) * (1.0 - 1.0 / result.frames);
    result.depth = depth;
    return result;
}

#endif
