// Penumbra: percentage-closer soft shadows whose search ends at a known radius.
//
// Computes:   visibility of a disc light, as PcssAngular.hlsl does, for receivers of which it is known that no
//             blocker's penumbra is wider than a radius; and the radius of the penumbra.
// Source:     Fernando, "Percentage-Closer Soft Shadows" (2005); the changes are Penumbra's own:
//             - The search's samples stand for rings of growing width, so the cone in which they find blockers has a
//               slack that grows with their distance. One test replaces that of the light's cone and of a wider one.
//             - Up to 4.25 texels of radius the filter weighs every texel once, by how much of it the disc covers.
//             - Distances are compared by their squares, and a quad has one product with the receiver's plane.
// Inputs:     shadow map (raw reads), point sampler; TexelReceiver; ConeScales of its tile; the radius.
// Cost:       searchSamples fetches where nothing blocks; 4, 9, 16 or 25 more up to 4.25 texels of radius, and
//             filterSamples more beyond; 4 more there where a low blocker stands, too.
// Guarantees: [0, 1]; exactly 1 without blockers, exactly 0 where every texel read blocks; texels outside the tile are
//             not read. NaN texels do not block.
// Use it:     behind a classification that knows the radius. Not: on devices without gather.
#ifndef PENUMBRA_PCSS_BOUNDED_HLSL
#define PENUMBRA_PCSS_BOUNDED_HLSL

#include "PcssAngular.hlsl"
#include "Parameters/PcssBoundedParameters.hlsl"

// The share of a sample's distance that the search takes for it, so that its cone is wider than the light's.
static const float kConePerTexel = 0.5;
// The widest radius for which every texel is weighed.
static const float kWidestTexelDisc = 4.25;
// The narrowest radius of a kernel of 4 x 4 texels. With a smaller one edges are harder, with a larger one light leaks
// at contacts.
static const float kNarrowestTexelDisc = 1.125;
// No texel has a gap as large.
static const float kNoGap = 4.0;
// The golden angle's cosine and sine.
static const float2 kGoldenTurn = float2(-0.73736888, 0.67549029);

struct TexelReceiver
{
    float2 centre;      // texel coordinates
    float2 lowCorner;   // the smallest and the largest corner of a quad of texels in the tile
    float2 highCorner;
    float2 texelSize;   // atlas UV
    float depth;
    float2 gradient;    // stored depth per texel
    float4 quadRise;    // the plane's rise from a quad's corner to its texels
    float2 rotation;
};

struct TexelQuadTest
{
    float4 gap;        // how much nearer to the light than the receiver each texel lies, stored depth
    float4 abovePlane; // the same above the receiver's plane at the texel's centre
    float2 corner;     // corner that the four texels share
};

// centre and gradient are in texels of the atlas.
TexelReceiver MakeTexelReceiver(float2 centre, float depth, float2 gradient, float2 rotation, ShadowTile tile)
{
    const TileBounds bounds = BoundsInTexels(tile);
    const float2 across = 0.5 * gradient;
    TexelReceiver receiver;
    receiver.centre = min(max(FiniteOr(centre, bounds.minimum), bounds.minimum), bounds.maximum);
    receiver.lowCorner = bounds.minimum + 1.0;
    receiver.highCorner = max(bounds.maximum - 1.0, receiver.lowCorner);
    receiver.texelSize = tile.atlasTexelSize.xy;
    receiver.depth = SanitizeReceiverDepth(depth);
    receiver.gradient = gradient;
    receiver.quadRise = float4(across.y - across.x, across.x + across.y, across.x - across.y, -across.x - across.y);
    receiver.rotation = rotation;
    return receiver;
}

TexelQuadTest TestTexels(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float2 texels)
{
    TexelQuadTest test;
    test.corner = min(max(floor(texels + 0.5), receiver.lowCorner), receiver.highCorner);
    const float4 depths = GATHER_RED_TEXTURE2D(shadowMap, sampler_point, test.corner * receiver.texelSize);
    const float plane = receiver.depth + dot(receiver.gradient, test.corner - receiver.centre);
    test.gap = DepthGap(depths, float4(receiver.depth, receiver.depth, receiver.depth, receiver.depth));
    test.abovePlane = DepthGap(depths, LimitToNearPlane(plane + receiver.quadRise));
    return test;
}

// Which texels block: those above the plane whose gap exceeds an offset >= 0, stored depth. A NaN does not.
bool4 BlockingTexels(TexelQuadTest test, float4 offset)
{
    return min(test.abovePlane, test.gap - offset) > 0.0;
}

// The distances of the texels from the receiver.
float4 DistancesOfTexels(TexelQuadTest test, TexelReceiver receiver)
{
    const float2 before = test.corner - receiver.centre - 0.5;
    const float2 after = before + 1.0;
    const float4 x = float4(before.x, after.x, after.x, before.x);
    const float4 y = float4(after.y, after.y, before.y, before.y);
    return sqrt(x * x + y * y);
}

// The gap at which the light's cone begins at this distance. A texel is a square, not a point, so it may lie `slack`
// texels beside the cone. At `cap`, stored depth, the cone ends.
float4 ConeOffsets(float4 distances, float slack, float cap, float depthPerTexel)
{
    return min(max(distances - slack, 0.0) * depthPerTexel, cap);
}

// Lit and blocked weight.
float2 WeighTexels(float4 weight, bool4 blocking)
{
    const float4 lit = blocking ? 0.0 : weight;
    const float4 blocked = weight - lit;
    return float2((lit.x + lit.y) + (lit.z + lit.w), (blocked.x + blocked.y) + (blocked.z + blocked.w));
}

struct BoundedSearch
{
    float gap;         // mean gap of the blockers, stored depth
    float smallestGap;
    bool blocked;
};

BoundedSearch SearchBounded(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                            float largestRadius, int samples)
{
    // The radii are those of GeometricRadius(), but for the first, which is at the receiver.
    const float ratio = pow(max(largestRadius / kSmallestSlackTexels, 1.0), 1.0 / float(samples));
    float reach = kSmallestSlackTexels * ratio * sqrt(ratio);
    float2 direction = receiver.rotation;
    float2 texels = receiver.centre;
    float offset = 0.0;
    float gaps = 0.0;
    float count = 0.0;
    float4 smallest = float4(kNoGap, kNoGap, kNoGap, kNoGap);
    UNITY_LOOP
    for (int i = 0; i < samples; ++i)
    {
        const TexelQuadTest test = TestTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, texels);
        const bool4 blocking = BlockingTexels(test, offset);
        const float4 one = blocking ? 1.0 : 0.0;
        gaps += dot(test.gap, one);
        count += (one.x + one.y) + (one.z + one.w);
        smallest = min(smallest, blocking ? test.gap : kNoGap);
        direction = RotateDisk(direction, kGoldenTurn);
        texels = receiver.centre + direction * reach;
        offset = max(reach * kConePerTexel - kSmallestSlackTexels, 0.0) * depthPerTexel;
        reach *= ratio;
    }
    BoundedSearch search;
    search.blocked = count > 0.0;
    search.gap = AverageGap(gaps, count);
    search.smallestGap = min(min(smallest.x, smallest.y), min(smallest.z, smallest.w));
    return search;
}

// The lit share of the 4 x 4 texels around the receiver, by a weight that falls evenly with the distance to `outermost`
// texels. Texels from largestGap up have no weight: what lies below them is not known.
float FilterNearTexels(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                       float outermost, float cap, float largestGap)
{
    const float2 corner = floor(receiver.centre + 0.5);
    float2 sums = float2(0.0, 0.0); // x: lit, y: blocked
    UNITY_LOOP
    for (int i = 0; i < 4; ++i)
    {
        const float2 away = float2((i & 1) == 0 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
        const TexelQuadTest test = TestTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, corner + away);
        const float4 distances = DistancesOfTexels(test, receiver);
        const float4 offsets = ConeOffsets(distances, kWidestBlockTexels + kBlockReachTexels, cap, depthPerTexel);
        const float4 weight = test.gap < largestGap ? max(1.0 - distances / outermost, 0.0) : 0.0;
        sums += WeighTexels(weight, BlockingTexels(test, offsets));
    }
    return LitShare(sums.x, sums.y);
}

// The lit share of a disc of at most kWidestTexelDisc texels, every texel of which is weighed by how much of it lies in
// the disc.
float FilterTexelDisc(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                      float radius, float cap)
{
    // Beyond so many quads each way no texel's square meets the disc.
    const float across = ceil(radius + 0.5);
    const float2 first = floor(receiver.centre + 0.5) - across + 1.0;
    const float2 last = first + 2.0 * across - 1.0;
    float2 corner = first;
    float2 sums = float2(0.0, 0.0); // x: lit, y: blocked
    UNITY_LOOP
    while (corner.y < last.y)
    {
        const TexelQuadTest test = TestTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, corner);
        const float4 distances = DistancesOfTexels(test, receiver);
        const float4 offsets = ConeOffsets(distances, kQuadSlackTexels, cap, depthPerTexel);
        sums += WeighTexels(min(max(radius + 0.5 - distances, 0.0), 1.0), BlockingTexels(test, offsets));
        corner.x += 2.0;
        if (!(corner.x < last.x)) corner = float2(first.x, corner.y + 2.0);
    }
    return LitShare(sums.x, sums.y);
}

// The lit share of a disc by samples.
float FilterSampledDisc(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                        float radius, float slack, float cap, int samples)
{
    float2 sums = float2(0.0, 0.0); // x: lit, y: blocked
    float2 direction = receiver.rotation;
    const float perSample = 1.0 / float(samples);
    UNITY_LOOP
    for (int i = 0; i < samples; ++i)
    {
        const float reach = radius * sqrt((float(i) + 0.5) * perSample);
        const float2 texels = receiver.centre + direction * reach;
        const TexelQuadTest test = TestTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, texels);
        const float offset = min(max(reach - slack, 0.0) * depthPerTexel, cap);
        sums += WeighTexels(BilinearWeights(texels, test.corner), BlockingTexels(test, offset));
        direction = RotateDisk(direction, kGoldenTurn);
    }
    return LitShare(sums.x, sums.y);
}

struct BoundedResult
{
    float visibility;
    float radius; // the penumbra's, texels; 0 where nothing blocks
};

// The radius of the widest penumbra that the softness cap leaves, texels.
float CapRadius(PcssBoundedParameters parameters, ConeScales scales)
{
    return min(0.5 * BoundedOrLow(parameters.maxPenumbraMetres, 0.0, 1e9) * scales.texelsPerMetre,
               scales.largestRadius);
}

// The radius of the widest penumbra that any blocker of the map can make at a receiver of this depth, texels.
float WidestRadius(float depth, PcssBoundedParameters parameters, ConeScales scales)
{
    return min(PenumbraRadius(LargestGap(depth), scales), CapRadius(parameters, scales));
}

// No blocker's penumbra has a radius above largestRadius, texels.
BoundedResult FilterBounded(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, ConeScales scales,
                            float largestRadius, PcssBoundedParameters parameters)
{
    const float outermost = max(largestRadius, kWidestBlockTexels);
    const BoundedSearch search =
        SearchBounded(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, scales.depthPerTexel, outermost,
                      BoundedSampleCount(parameters.searchSamples));
    BoundedResult result;
    result.visibility = 1.0;
    result.radius = 0.0;
    if (!search.blocked) return result;
    const float radius = min(search.gap * scales.texelsPerDepth, outermost);
    const float cap = kConeHeightShare * search.gap;
    const bool narrow = radius <= kWidestBlockTexels;
    result.radius = radius;
    if (narrow || search.smallestGap < kLowBlockerTexels * scales.depthPerTexel)
    {
        const float lowGap = min(kLowBlockerTexels * scales.depthPerTexel, kLowBlockerShare * search.gap);
        const float kernel = min(max(radius, kNarrowestTexelDisc), kWidestBlockTexels) + kBlockReachTexels;
        result.visibility = FilterNearTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, scales.depthPerTexel,
                                             kernel, cap, narrow ? kNoGap : lowGap);
    }
    if (!narrow && result.visibility > 0.0)
    {
        float disc;
        UNITY_BRANCH
        if (radius <= kWidestTexelDisc)
            disc = FilterTexelDisc(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, scales.depthPerTexel, radius,
                                   cap);
        else
            disc = FilterSampledDisc(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, scales.depthPerTexel,
                                     radius - kQuadReachTexels, kQuadSlackTexels - kQuadReachTexels, cap,
                                     BoundedSampleCount(parameters.filterSamples));
        result.visibility = min(result.visibility, disc);
    }
    return result;
}

// For receivers of which nothing is known, in forward shaders for example.
float FilterPcssBounded(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                        ShadowReceiver receiver, ShadowTile tile, PcssBoundedParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const float2 size = tile.atlasTexelSize.zw;
    const TexelReceiver texels =
        MakeTexelReceiver(receiver.shadowCoord.xy * size, receiver.shadowCoord.z,
                          BoundGradient(receiver.depthGradient) * tile.atlasTexelSize.xy,
                          UnitRotation(receiver.rotation), tile);
    const BoundedResult result =
        FilterBounded(TEXTURE2D_ARGS(shadowMap, sampler_point), texels, scales,
                      WidestRadius(texels.depth, parameters, scales), parameters);
    return SanitizeVisibility(result.visibility);
}

#endif
