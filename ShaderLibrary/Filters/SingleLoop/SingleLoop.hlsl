// Penumbra: soft shadows of one loop over the rings of a disc.
//
// Computes:   visibility of a disc light: each tap of a spiral, one to a ring of the disc, sets a bit where it is
//             blocked and adds its gap to a mean; the penumbra that the mean gap makes is a smaller disc, and the lit
//             share of the area of its rings is the visibility. Search and filter of PCSS are the same taps.
// Source:     Candycat, "Graphics Study: RDR2, shadows" (2021), which describes captured frames of a game: 32 taps of a
//             Vogel disk with a radius of 48 texels in the nearest of four cascades of 2048 x 2048, and of as many
//             metres in the others. Fernando, "Percentage-Closer Soft Shadows" (2005); Vogel (1979).
// Inputs:     shadow map (raw reads; neither sampler is used); ShadowReceiver; ShadowTile; SingleLoopParameters.
// Cost:       `samples` fetches, always.
// Guarantees: [0, 1] for any input; exactly 1 without blockers, exactly 0 where every texel read blocks; texels outside
//             the tile are not read.
// Use it:     where every pixel must cost the same. Not: for penumbrae much narrower than the disc: one that ends
//             inside of the innermost ring (0.18 of the disc's radius with rings of equal area, 0.03 with equal widths)
//             has one tap.
//
// What the description has otherwise or leaves open, and what is computed here:
// - It divides the area of all blocked rings by that of the penumbra. Rings outside of the penumbra do not belong to
// it:
//   with them the quotient exceeds 1 beside any large blocker. Here only rings inside count, the outermost in part.
// - It takes the mean depth of all 32 taps. Taps that are not blocked say nothing of the blocker, and with them in the
//   mean penumbrae narrow where few taps are blocked, at their outer ends. Here the mean is over blockers.
// - It converts depth to radius by an unstated rule. Here: tan(a / 2) times the gap (Core/Penumbra.hlsl).
// - It compares with a bias. Here each tap is compared at its texel's centre with the receiver's plane.
// - The disc is no wider than the cone of the farthest blocker that the map can hold. Its largest radius, 0.05 m, and
//   0.1 m with rings of equal width, are those with the smallest error in penumbra, averaged over lights of 0.53, 2 and
//   5 degrees (measure --set discRadiusMetres=0.03,0.05,0.1). A wider disc blurs narrow penumbrae, a narrower one cuts
//   wide ones. The technique single-loop-32-wide has 0.1 m with rings of equal area: 48 texels of a map of 2048 x 2048
//   texels that shows 4.3 m of the world.
#ifndef PENUMBRA_SINGLE_LOOP_HLSL
#define PENUMBRA_SINGLE_LOOP_HLSL

#include "../Taps/TexelQuad.hlsl"
#include "../../Core/Disk.hlsl"
#include "../../Core/RingMask.hlsl"
#include "Parameters/SingleLoopParameters.hlsl"

// The distance from a tap to the centre of the texel that contains it: half a texel's diagonal, and what rounding adds.
static const float kTapToCentreTexels = 0.75;

struct SingleLoop
{
    QuadReceiver receiver;
    ConeScales scales;
    float2 rotation;
    float radius;          // radius of the disc, texels
    float smallestRadius;  // smallest radius of the disc and the penumbra, texels
    int taps;
    int exponent;          // exponent of RingMask.hlsl
};

SingleLoop PrepareSingleLoop(ShadowReceiver receiver, ShadowTile tile, SingleLoopParameters parameters)
{
    SingleLoop loop;
    loop.receiver = PrepareQuads(receiver, tile);
    loop.scales = ConeScalesOf(tile);
    loop.rotation = UnitRotation(receiver.rotation);
    loop.smallestRadius = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    loop.radius = SearchRadius(loop.receiver.depth, 2.0 * BoundedOrLow(parameters.discRadiusMetres, 0.0, 1e6),
                               loop.smallestRadius, loop.scales);
    loop.taps = BoundedRingCount(parameters.samples);
    loop.exponent = BoundedRingExponent(parameters.ringExponent);
    return loop;
}

// The gap of the texel that contains `texels` or, if it lies beside the tile, of the tile's nearest texel: how much
// nearer to the light than the receiver it lies, stored depth. It is 0 where the texel does not block: where it lies no
// higher than the receiver or the receiver's plane.
float BlockingGap(TEXTURE2D(shadowMap), QuadReceiver receiver, float2 texels)
{
    const float2 last = max(receiver.bounds.maximum - 1.0, receiver.bounds.minimum);
    const float2 texel = min(max(floor(texels), receiver.bounds.minimum), last);
    const float mapDepth = SanitizeMapDepth(LOAD_TEXTURE2D_LOD(shadowMap, int2(texel), 0).x);
    const float2 away = texel + 0.5 - receiver.centre;
    const float plane = KeepBehindNearPlane(receiver.depth + dot(receiver.gradient, away));
    return DepthGap(mapDepth, plane) > 0.0 ? max(DepthGap(mapDepth, receiver.depth), 0.0) : 0.0;
}

float2 RingTap(int ring, SingleLoop loop)
{
    const float radius = loop.radius * RingTapRadius(ring, loop.taps, loop.exponent);
    return loop.receiver.centre + RotateDisk(FibonacciDirection(ring), loop.rotation) * radius;
}

float RunSingleLoop(TEXTURE2D(shadowMap), SingleLoop loop)
{
    // The words are an array of their own because FXC does not write to a member of a struct by an index of a loop.
    uint words[kRingWords] = EmptyRingMask().words;
    float gapSum = 0.0;
    float blockers = 0.0;
    UNITY_LOOP
    for (int i = 0; i < loop.taps; ++i)
    {
        const float gap = BlockingGap(shadowMap, loop.receiver, RingTap(i, loop));
        if (gap > 0.0)
        {
            words[i >> 5] |= RingBit(i);
            gapSum += gap;
            blockers += 1.0;
        }
    }
    if (!(blockers > 0.0)) return 1.0;
    RingMask blocked;
    blocked.words = words;
    const float penumbra = max(PenumbraRadius(AverageGap(gapSum, blockers), loop.scales), loop.smallestRadius);
    const float rings = RingsInside(penumbra / loop.radius, loop.taps, loop.exponent);
    return SanitizeVisibility(RingVisibility(blocked, rings, loop.exponent));
}

float FilterSingleLoop(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                       ShadowReceiver receiver, ShadowTile tile, SingleLoopParameters parameters)
{
    return RunSingleLoop(shadowMap, PrepareSingleLoop(receiver, tile, parameters));
}

#endif
