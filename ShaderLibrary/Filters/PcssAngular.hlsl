// Penumbra: percentage-closer soft shadows by the light's angular diameter.
//
// Computes:   visibility of a disc light: mean gap of the blockers in the light's cone, then the lit share of a disc
//             as wide as the penumbra that gap makes.
// Source:     Fernando, "Percentage-Closer Soft Shadows" (2005); cone-shaped sampling and Fibonacci disks as in Unity's
//             HDRP; scales are geometric (tan(a/2) per metre), half of HDRP's. PcssHdrp.hlsl is HDRP's own rule.
// Inputs:     shadow map (raw reads; the comparison sampler is not used), point sampler; ShadowReceiver; ShadowTile;
//             PcssAngularParameters.
// Cost:       blockerSamples fetches where nothing blocks, else blockerSamples + filterSamples.
// Guarantees: [0, 1] for any input; exactly 1 without blockers, exactly 0 where every texel read blocks; texels outside
//             the tile are not read.
// Use it:     from about one texel of penumbra radius up. Not: on devices without gather.
//
// Two choices differ from the textbook. The search's radius is that of the farthest blocker the map can hold, so its
// samples have as many in every octave of radius, and one at the receiver: spread evenly, or by 1/r, they step over low
// blockers, whose cone is narrow, and leak at contacts. And each texel is tested at its centre against the receiver's
// plane, by gather, so a wide kernel does not shadow the surface it lies on.
#ifndef PENUMBRA_PCSS_ANGULAR_HLSL
#define PENUMBRA_PCSS_ANGULAR_HLSL

#include "TexelQuad.hlsl"
#include "../Core/Disk.hlsl"
#include "../Core/TechniqueParameters.hlsl"

// A texel's half diagonal: with less slack a texel's own centre could miss the cone that its square lies in.
static const float kSmallestSlackTexels = 0.75;
// How far a sample's bilinear weights carry an edge beyond the sample: from 0 to 1 the kernel is that much wider than
// its disc, on either side.
static const float kQuadReachTexels = 0.5;
// No texel of a sample's quad with a weight is farther from the sample than a texel's diagonal.
static const float kQuadSlackTexels = 1.5;

// Where the search's sample lies, in texels from the receiver. clump below 1: geometric.
float SearchSampleRadius(int index, int count, float clump, float radius)
{
    const float outermost = max(radius, 1e-3);
    if (clump < 1.0) return GeometricRadius(index, count, min(kSmallestSlackTexels, outermost), outermost);
    return FibonacciRadius(index, count, clump) * radius;
}

BlockerEstimate SearchBlockers(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, LightCone cone,
                               float2 rotation, float radius, PcssAngularParameters parameters)
{
    const int count = BoundedSampleCount(parameters.blockerSamples);
    const float clump = BoundedOrLow(parameters.blockerClump, 0.0, 8.0);
    float gapSum = 0.0;
    BlockerEstimate estimate;
    estimate.count = 0.0;
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        const float reach = i == 0 ? 0.0 : SearchSampleRadius(i, count, clump, radius);
        const float2 offset = RotateDisk(FibonacciDirection(i), rotation) * reach;
        const TexelQuad quad = ReadQuad(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, cone, receiver.centre + offset);
        gapSum += dot(quad.gap, quad.blocking);
        estimate.count += dot(quad.blocking, float4(1.0, 1.0, 1.0, 1.0));
    }
    estimate.gap = AverageGap(gapSum, estimate.count);
    return estimate;
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
        const float2 offset = RotateDisk(FibonacciDisk(i, count, 1.0), rotation) * radius;
        const TexelQuad quad = ReadQuad(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, cone, receiver.centre + offset);
        blocked += dot(quad.weight, quad.blocking);
        lit += dot(quad.weight, 1.0 - quad.blocking);
    }
    return LitShare(lit, blocked);
}

// What the search at a receiver leads to.
struct AngularSearch
{
    QuadReceiver receiver;
    LightCone cone;
    float2 rotation;
    float smallestRadius; // texels
    float radius;         // texels, of the search
    BlockerEstimate blockers;
};

AngularSearch SearchAngular(TEXTURE2D_PARAM(shadowMap, sampler_point), ShadowReceiver receiver, ShadowTile tile,
                            PcssAngularParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    AngularSearch search;
    search.receiver = PrepareQuads(receiver, tile);
    search.rotation = UnitRotation(receiver.rotation);
    search.smallestRadius = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    search.cone.scales = scales;
    search.cone.slackTexels = max(search.smallestRadius, kSmallestSlackTexels);
    search.cone.largestOffset = BoundedOrLow(parameters.maxSamplingMetres, 0.0, 1e6) * scales.depthPerMetre;

    search.radius = SearchRadius(search.receiver.depth, parameters.maxPenumbraMetres, search.smallestRadius, scales);
    search.blockers = SearchBlockers(TEXTURE2D_ARGS(shadowMap, sampler_point), search.receiver, search.cone,
                                     search.rotation, search.radius, parameters);
    return search;
}

// Radius, texels, of what the blockers make; no wider than the search. Means nothing without blockers.
float FoundPenumbra(AngularSearch search)
{
    return min(PenumbraRadius(search.blockers.gap, search.cone.scales), search.radius);
}

float FilterPcssAngular(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                        ShadowReceiver receiver, ShadowTile tile, PcssAngularParameters parameters)
{
    const AngularSearch search = SearchAngular(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, tile, parameters);
    if (!(search.blockers.count > 0.0)) return 1.0;

    const float penumbra = FoundPenumbra(search);
    const float radius = max(penumbra - kQuadReachTexels, search.smallestRadius);
    LightCone cone = search.cone;
    // A wall at the blockers' mean gap darkens the whole kernel, also where the kernel is wider than the penumbra.
    cone.slackTexels = radius - penumbra + kQuadSlackTexels;
    return SanitizeVisibility(FilterDisc(TEXTURE2D_ARGS(shadowMap, sampler_point), search.receiver, cone,
                                         search.rotation, radius, parameters.filterSamples));
}

// Width of the penumbra from 0 to 1, metres across the light, that the blockers found at the receiver make; 0 where
// nothing blocks. Costs the search alone.
float PenumbraWidthAngular(TEXTURE2D_PARAM(shadowMap, sampler_point), ShadowReceiver receiver, ShadowTile tile,
                           PcssAngularParameters parameters)
{
    const AngularSearch search = SearchAngular(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, tile, parameters);
    if (!(search.blockers.count > 0.0)) return 0.0;
    return 2.0 * FoundPenumbra(search) / max(search.cone.scales.texelsPerMetre, 1e-9);
}

#endif
