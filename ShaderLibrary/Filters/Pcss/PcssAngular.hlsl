// Penumbra: percentage-closer soft shadows by the light's angular diameter.
//
// Computes:   visibility of a disc light: mean gap of the blockers in the light's cone, then the lit share of a disc
//             as wide as the penumbra that gap makes.
// Source:     Fernando, "Percentage-Closer Soft Shadows" (2005); cone-shaped sampling and Fibonacci disks as in Unity's
//             HDRP; scales are geometric (tan(a/2) per metre), half of HDRP's. PcssHdrp.hlsl is HDRP's own rule.
// Inputs:     shadow map (raw reads; the comparison sampler is not used), point sampler; ShadowReceiver; ShadowTile;
//             PcssAngularParameters.
// Cost:       blockerSamples fetches where nothing blocks, else 4 more where the penumbra is narrow and filterSamples
//             more where it is wide, and 4 more there where a low blocker stands, too.
// Guarantees: [0, 1] for any input; exactly 1 without blockers, exactly 0 where every texel read blocks; texels outside
//             the tile are not read.
// Use it:     from about one texel of penumbra radius up. Not: on devices without gather.
//
// Choices that differ from the textbook, each measured (Documentation~/presets.md):
// - The search's radius is that of the farthest blocker the map can hold, so its samples have as many in every octave
// of
//   radius, and one at the receiver: spread evenly, or by 1/r, they step over low blockers, whose cone is narrow, and
//   leak at contacts.
// - Where no sample hits a blocker inside the light's cone, those beside it say how high the caster there stands, and
// the
//   filter decides: at the rim of a penumbra a sliver of the cone is blocked, which few samples hit.
// - Each texel is tested at its centre against the receiver's plane, by gather, so a wide kernel does not shadow the
//   surface it lies on.
// - The filter's cone ends at a share of the blockers' mean gap. A ray to the light passes low blockers close to the
//   receiver; the filter looks for them at the distance of the mean blocker, where a whole cone would reject every low
//   one: below a roof with a hole, or where walls of two heights hide the light together, light would leak.
// - Up to 1.25 texels of radius every texel of 4 x 4 is weighed once: no noise, and 4 fetches.
// - Where a low blocker and a high one overlap, the mean of their gaps belongs to neither: a table's shadow on its own
//   frame would vanish below the shadow of a tree. Low blockers, whose penumbra is narrower than two texels, are
//   weighed by themselves, and the darker of both counts.
#ifndef PENUMBRA_PCSS_ANGULAR_HLSL
#define PENUMBRA_PCSS_ANGULAR_HLSL

#include "../Taps/TexelQuad.hlsl"
#include "../../Core/Disk.hlsl"
#include "Parameters/PcssAngularParameters.hlsl"

// A texel's half diagonal: with less slack a texel's own centre could miss the cone that its square lies in.
static const float kSmallestSlackTexels = 0.75;
// A sample's bilinear weights carry an edge this far beyond the sample: from 0 to 1 the kernel is that much wider than
// its disc, on either side.
static const float kQuadReachTexels = 0.5;
// The search looks in a cone this many times as wide as the light's where the light's cone is empty. At 3 and at 10 the
// error in penumbra is 0 to 15 % larger with 8 samples; at 10 a third more lit pixels are darkened.
static const float kNearbyWidth = 5.0;
// The height of the filter's cone, as a share of the blockers' mean gap. Leaks and false shadows balance from 0.1 to
// 0.25.
static const float kConeHeightShare = 0.15;
// The widest filter radius for which the 4 x 4 texels around the receiver are enough, and how far beyond the radius
// their weight, which falls evenly with the distance, comes to nothing. With a wider reach edges are softer, and light
// leaks at contacts.
static const float kWidestBlockTexels = 1.25;
static const float kBlockReachTexels = 0.4;
// Blockers whose penumbra's radius is below this, and whose gap is below this share of the mean, are low ones beside
// high ones. Twice the radius changes no error by 1 % and costs 0.1 fetches.
static const float kLowBlockerTexels = 2.0;
static const float kLowBlockerShare = 0.25;
// A smaller radius would leave a receiver between four texels without any texel that has a weight.
static const float kSmallestBlockTexels = 0.75;
// No two depths of a map have this gap.
static const float kAnyGap = 2.0;
// No texel of a sample's quad with a weight is farther from the sample than a texel's diagonal.
static const float kQuadSlackTexels = 1.5;
// A cone of FilterFound is wider than the light's by at most this much, beyond the smallest filter radius.
static const float kWidestSlackTexels = 1.75;
// The mean gap may be larger by this factor, since floats round it.
static const float kRoundedShare = 1.001;

// The place of a sample of the search, in texels from the receiver. A clump below 1 means geometric spacing.
float SearchSampleRadius(int index, int count, float clump, float radius)
{
    const float outermost = max(radius, 1e-3);
    if (clump < 1.0) return GeometricRadius(index, count, min(kSmallestSlackTexels, outermost), outermost);
    return FibonacciRadius(index, count, clump) * radius;
}

// The gap, stored depth, below which a blocker's penumbra is narrow enough for a low blocker.
float LowBlockerGap(LightCone cone)
{
    return kLowBlockerTexels * cone.scales.depthPerTexel;
}

// Finds the blockers inside the cone or, where there is none, those in the wider one. coneHeight, stored depth, is
// where the filter's cone ends. A cone that the search found empty keeps its height: nothing in it could leak.
// lowBlockers is how many texels inside the cone are low blockers.
BlockerEstimate SearchBlockers(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, LightCone cone,
                               float2 rotation, float radius, PcssAngularParameters parameters,
                               out float coneHeight, out float lowBlockers)
{
    const int count = BoundedSampleCount(parameters.blockerSamples);
    const float clump = BoundedOrLow(parameters.blockerClump, 0.0, 8.0);
    LightCone wide = cone;
    wide.scales.depthPerTexel = cone.scales.depthPerTexel / kNearbyWidth;
    const float4 each = float4(1.0, 1.0, 1.0, 1.0);
    float2 inside = float2(0.0, 0.0); // x: sum of gaps, y: number of texels
    float2 nearby = float2(0.0, 0.0);
    const float lowGap = LowBlockerGap(cone);
    lowBlockers = 0.0;
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        const float reach = i == 0 ? 0.0 : SearchSampleRadius(i, count, clump, radius);
        const float2 offset = OffsetInMap(RotateDisk(FibonacciDirection(i), rotation) * reach, receiver);
        const TexelQuad quad = ReadQuad(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, cone,
                                        receiver.centre + offset);
        const float4 close = TexelsInCone(quad.gap, quad.abovePlane, quad.radius, wide);
        inside += float2(dot(quad.gap, quad.blocking), dot(quad.blocking, each));
        lowBlockers += dot(quad.blocking, 1.0 - step(lowGap, quad.gap));
        nearby += float2(dot(quad.gap, close), dot(close, each));
    }
    const float2 found = inside.y > 0.0 ? inside : nearby;
    BlockerEstimate estimate;
    estimate.gap = AverageGap(found.x, found.y);
    estimate.count = found.y;
    coneHeight = inside.y > 0.0 ? min(cone.largestOffset, kConeHeightShare * estimate.gap) : cone.largestOffset;
    return estimate;
}

// The lit share of the 4 x 4 texels around the receiver, by a weight that falls evenly with the distance. The centres
// of texels beside the block are 2 texels away or more, where there is no weight left: nothing jumps where the block
// moves on by a texel. Texels from largestGap (stored depth) up have no weight: what lies below them is not known.
float FilterBlock(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, LightCone cone, float radius,
                  float largestGap)
{
    const float2 corner = floor(receiver.centre + 0.5);
    const float outermost = max(radius + kBlockReachTexels, kSmallestBlockTexels);
    float lit = 0.0;
    float blocked = 0.0;
    UNITY_LOOP
    for (int i = 0; i < 4; ++i)
    {
        const float2 away = float2((i & 1) == 0 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
        const TexelQuad quad = ReadQuad(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, cone, corner + away);
        const float4 weight = max(1.0 - quad.radius / outermost, 0.0) * (1.0 - step(largestGap, quad.gap));
        blocked += dot(weight, quad.blocking);
        lit += dot(weight, 1.0 - quad.blocking);
    }
    return LitShare(lit, blocked);
}

float FilterDisc(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, LightCone cone, float2 rotation,
                 float radius, int samples)
{
    const int count = BoundedSampleCount(samples);
    float lit = 0.0;
    float blocked = 0.0;
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        const float2 offset = OffsetInMap(RotateDisk(FibonacciDisk(i, count, 1.0), rotation) * radius, receiver);
        const TexelQuad quad = ReadQuad(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, cone,
                                        receiver.centre + offset);
        blocked += dot(quad.weight, quad.blocking);
        lit += dot(quad.weight, 1.0 - quad.blocking);
    }
    return LitShare(lit, blocked);
}

// The search at a receiver, and what it leads to.
struct AngularSearch
{
    QuadReceiver receiver;
    LightCone cone;
    float2 rotation;
    float smallestRadius; // texels
    float radius;         // radius of the search, texels
    BlockerEstimate blockers;
    float coneHeight;     // height of the filter's cone, stored depth
    float lowBlockers;    // number of texels that are low blockers
};

// rotation is of unit length. scales are those at the receiver.
AngularSearch SearchAround(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, float2 rotation,
                           ConeScales scales, PcssAngularParameters parameters)
{
    AngularSearch search;
    search.receiver = receiver;
    search.rotation = rotation;
    search.smallestRadius = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    search.cone.scales = scales;
    search.cone.slackTexels = max(search.smallestRadius, kSmallestSlackTexels);
    search.cone.largestOffset = BoundedOrLow(parameters.maxSamplingMetres, 0.0, 1e6) * scales.depthPerMetre;

    search.radius = SearchRadius(search.receiver.depth, parameters.maxPenumbraMetres, search.smallestRadius, scales);
    search.blockers = SearchBlockers(TEXTURE2D_ARGS(shadowMap, sampler_point), search.receiver, search.cone,
                                     search.rotation, search.radius, parameters, search.coneHeight, search.lowBlockers);
    return search;
}

AngularSearch SearchAngular(TEXTURE2D_PARAM(shadowMap, sampler_point), ShadowReceiver receiver, ShadowTile tile,
                            PcssAngularParameters parameters)
{
    return SearchAround(TEXTURE2D_ARGS(shadowMap, sampler_point), PrepareQuads(receiver, tile),
                        UnitRotation(receiver.rotation), ConeScalesOf(tile), parameters);
}

// The radius, texels, of the penumbra that the blockers make; no wider than the search. It means nothing without
// blockers.
float FoundPenumbra(AngularSearch search)
{
    return min(PenumbraRadius(search.blockers.gap, search.cone.scales), search.radius);
}

float FilterFound(TEXTURE2D_PARAM(shadowMap, sampler_point), AngularSearch search, int filterSamples)
{
    if (!(search.blockers.count > 0.0)) return 1.0;

    const float penumbra = FoundPenumbra(search);
    const float radius = max(penumbra - kQuadReachTexels, search.smallestRadius);
    const bool narrow = radius <= kWidestBlockTexels;
    LightCone cone = search.cone;
    cone.largestOffset = search.coneHeight;
    float visibility = 1.0;
    if (narrow || search.lowBlockers > 0.0)
    {
        // The cone has slack for all 4 x 4 texels, so that each texel in them that blocks hides light.
        cone.slackTexels = kWidestBlockTexels + kBlockReachTexels;
        const float lowGap = min(LowBlockerGap(cone), kLowBlockerShare * search.blockers.gap);
        visibility = FilterBlock(TEXTURE2D_ARGS(shadowMap, sampler_point), search.receiver, cone,
                                 min(radius, kWidestBlockTexels), narrow ? kAnyGap : lowGap);
    }
    if (!narrow && visibility > 0.0)
    {
        // A wall at the blockers' mean gap darkens the whole kernel, also where the kernel is wider than the penumbra.
        cone.slackTexels = radius - penumbra + kQuadSlackTexels;
        visibility = min(visibility, FilterDisc(TEXTURE2D_ARGS(shadowMap, sampler_point), search.receiver, cone,
                                                search.rotation, radius, filterSamples));
    }
    return SanitizeVisibility(visibility);
}

float FilterPcssAngular(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                        ShadowReceiver receiver, ShadowTile tile, PcssAngularParameters parameters)
{
    const AngularSearch search = SearchAngular(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, tile, parameters);
    return FilterFound(TEXTURE2D_ARGS(shadowMap, sampler_point), search, parameters.filterSamples);
}

// The width of the penumbra from 0 to 1, metres across the light, that the blockers found at the receiver make; 0 where
// nothing blocks. It costs the search alone.
float PenumbraWidthAngular(TEXTURE2D_PARAM(shadowMap, sampler_point), ShadowReceiver receiver, ShadowTile tile,
                           PcssAngularParameters parameters)
{
    const AngularSearch search = SearchAngular(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, tile, parameters);
    if (!(search.blockers.count > 0.0)) return 0.0;
    return 2.0 * FoundPenumbra(search) / max(search.cone.scales.texelsPerMetre, 1e-9);
}

#endif
