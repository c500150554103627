// Penumbra: smoothing of noisy penumbrae by their width, over eight pixels around each.
//
// Computes:   the mean of a pixel's visibility and of those pairs of opposite pixels around it that lie in its surface
//             and whose mean differs from it no more than noise does; the wider the penumbra on the screen, the more
//             these count. Single pixels that stand out from all around them are brought back first.
// Source:     Tomasi and Manduchi, "Bilateral Filtering for Gray and Color Images" (1998); pairs are Penumbra's own.
//             Across a penumbra visibility rises evenly, so the mean of two pixels on opposite sides is the pixel's
//             own but for noise, however much each differs from it. Stored depth is linear over the screen on a
//             plane, so two such pixels lie in the surface where the mean of their depths is the pixel's.
// Inputs:     words of PackNoisy() and stored camera depths of the pixel and of the eight around it, opposite ones in
//             turn.
// Cost:       no fetches.
// Guarantees: [0, 1]. A pixel whose neighbours have the same visibility keeps it to the last bit.
// Use it:     twice: for the nearest pixels, then for those three pixels away. Not: after a filter without noise.
#ifndef PENUMBRA_PENUMBRA_SMOOTHING_HLSL
#define PENUMBRA_PENUMBRA_SMOOTHING_HLSL

#include "../Core/FloatBits.hlsl"

#define SMOOTHING_TAPS 8

// The share of the depth's change over the pixels that a bend may have, and that of the depth itself.
static const float kSmoothingBend = 0.125;
static const float kSmoothingDepth = 0.001;

// A pixel's visibility, and the radius of its penumbra on the screen, pixels.
struct NoisyVisibility
{
    float visibility;
    float radius;
};

uint PackNoisy(NoisyVisibility value)
{
    return uint(value.visibility * 65535.0 + 0.5) | (f32tof16(min(value.radius, 60000.0)) << 16);
}

NoisyVisibility UnpackNoisy(uint word)
{
    NoisyVisibility value;
    value.visibility = float(word & 0xffffu) / 65535.0;
    value.radius = f16tof32(word >> 16);
    return value;
}

// The pixel's own, and of the eight around it.
struct SmoothingTaps
{
    uint here;
    uint words[SMOOTHING_TAPS];
    float depth;
    float depths[SMOOTHING_TAPS];
};

struct SmoothingReach
{
    float narrowest; // radius of a penumbra, pixels, up to which the pixels around do not count
    float widest;    // and from which they count in full
    float amplitude; // a mean of two pixels that differs more is an edge, not noise
    bool clips;      // but a pixel that is brighter or darker than all around it is, however much
};

// NearSmoothing is for the nearest pixels, FarSmoothing for those three pixels away, which are smoothed already.
SmoothingReach NearSmoothing()
{
    SmoothingReach reach;
    reach.narrowest = 0.5;
    reach.widest = 2.0;
    reach.amplitude = 0.3;
    reach.clips = true;
    return reach;
}

SmoothingReach FarSmoothing()
{
    SmoothingReach reach;
    reach.narrowest = 4.0;
    reach.widest = 10.0;
    reach.amplitude = 0.2;
    reach.clips = false;
    return reach;
}

// The pixels that are read, in opposite pairs.
int2 SmoothingOffset(int index)
{
    const int pair = index >> 1;
    const int2 way = int2(pair == 1 ? 0 : 1, pair == 0 ? 0 : pair == 3 ? -1 : 1);
    return (index & 1) == 0 ? way : -way;
}

// Whether any visibility around differs from the pixel's own.
bool HasNoise(SmoothingTaps taps)
{
    uint differing = 0;
    UNITY_UNROLL
    for (int i = 0; i < SMOOTHING_TAPS; ++i) differing |= taps.words[i] ^ taps.here;
    return (differing & 0xffffu) != 0;
}

NoisyVisibility SmoothPenumbra(SmoothingTaps taps, SmoothingReach reach)
{
    const NoisyVisibility here = UnpackNoisy(taps.here);
    bool inSurface[SMOOTHING_TAPS / 2];
    NoisyVisibility smoothed = here;
    float2 range = float2(1.0, 0.0); // x: lowest visibility of the pixels around, y: highest
    UNITY_UNROLL
    for (int i = 0; i < SMOOTHING_TAPS; i += 2)
    {
        const float after = taps.depths[i] - taps.depth;
        const float before = taps.depth - taps.depths[i + 1];
        inSurface[i / 2] = abs(after - before) < kSmoothingBend * abs(after + before) + kSmoothingDepth * taps.depth;
        if (!inSurface[i / 2]) continue;
        const NoisyVisibility one = UnpackNoisy(taps.words[i]);
        const NoisyVisibility other = UnpackNoisy(taps.words[i + 1]);
        range = float2(min(range.x, min(one.visibility, other.visibility)),
                       max(range.y, max(one.visibility, other.visibility)));
        smoothed.radius = max(smoothed.radius, max(one.radius, other.radius));
    }
    const float share = (smoothed.radius - reach.narrowest) / (reach.widest - reach.narrowest);
    const float weight = min(max(share, 0.0), 1.0);
    const bool clips = reach.clips && range.x <= range.y;
    const float within = clips ? min(max(here.visibility, range.x), range.y) : here.visibility;
    const float own = here.visibility + weight * (within - here.visibility);
    float2 sums = float2(own, 1.0); // x: visibility, y: weight
    UNITY_UNROLL
    for (int j = 0; j < SMOOTHING_TAPS; j += 2)
    {
        if (!inSurface[j / 2]) continue;
        const float2 around =
            float2(UnpackNoisy(taps.words[j]).visibility, UnpackNoisy(taps.words[j + 1]).visibility);
        const float pair = 0.5 * (around.x + around.y);
        const float alike = weight * max(1.0 - abs(pair - own) / reach.amplitude, 0.0);
        sums += 2.0 * alike * float2(pair, 1.0);
    }
    smoothed.visibility = min(sums.x / sums.y, 1.0);
    return smoothed;
}

#endif
