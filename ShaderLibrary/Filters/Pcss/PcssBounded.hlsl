// Penumbra: percentage-closer soft shadows whose search ends at a known radius, in two layers where shadows overlap.
//
// Computes:   visibility of a disc light, as PcssAngular.hlsl does, for receivers of which it is known that no
//             blocker's penumbra is wider than a radius; and the radius of the penumbra.
// Source:     Fernando, "Percentage-Closer Soft Shadows" (2005); the changes are Penumbra's own:
//             - The search's samples stand for rings of growing width, so the cone in which they find blockers is
//               wider than the light's. Where none is in the light's own, the filter's cone has no end, and decides.
//             - Where the search finds gaps that differ fourfold, blockers are two layers, which are filtered each by
//               its own penumbra. A texel of the high layer tells nothing of the low one, and leaves it out. The
//               light that passes both is the product.
//             - Up to 4.25 texels of radius the filter weighs every texel once, by how much of it the disc covers.
//             - Where the radius is at most 1.25 texels, four gathers are the filter, whatever a search would find.
// Inputs:     shadow map (raw reads), point sampler; TexelReceiver; ConeScales of its tile; the radius.
// Cost:       4 fetches where the radius is at most 1.25 texels. Else searchSamples fetches where nothing blocks; 4, 9,
//             16 or 25 more up to 4.25 texels of the penumbra's radius, and filterSamples more beyond. Two layers:
//             searchSamples more, and a filter for each, of which that of the low one runs up to three times.
// Guarantees: [0, 1]; exactly 1 without blockers, exactly 0 where every texel read blocks; texels outside the tile are
//             not read. NaN texels do not block.
// Use it:     behind a classification that knows the radius, or alone. Not: on devices without gather.
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
// The ratio of gaps from which on blockers are two layers. From 1.6 to 4 the error is the same; without layers it is
// 12 % larger under 5 degrees, over street, contact-boxes, garden and slabs.
static const float kLayersApart = 4.0;
// Where less of the low layer's disc is known, it is filtered again, in one more than twice as wide.
static const float kLeastKnown = 0.3;
static const int kLayerTries = 3;
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

// Returns which texels block: those above the plane whose gap exceeds an offset >= 0, stored depth. A NaN does not
// block.
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

// A layer of blockers: those with gaps above `from` and below `to`, stored depth. Higher ones hide the layer.
struct BlockerLayer
{
    float from;
    float to;
    float radius; // of the layer's penumbra, texels
    float cap;    // height of the cone in which the filter looks for blockers, stored depth
};

BlockerLayer AllBlockers()
{
    BlockerLayer layer;
    layer.from = 0.0;
    layer.to = kNoGap;
    layer.radius = 0.0;
    layer.cap = kNoGap;
    return layer;
}

// x: lit weight, y: blocked weight, z: weight of texels that a higher layer hides.
float3 WeighTexels(float4 weight, TexelQuadTest test, float4 offset, BlockerLayer layer)
{
    const float4 known = test.gap < layer.to ? weight : 0.0;
    const float4 lit = BlockingTexels(test, max(offset, layer.from)) ? 0.0 : known;
    const float4 blocked = known - lit;
    const float4 hidden = weight - known;
    return float3((lit.x + lit.y) + (lit.z + lit.w), (blocked.x + blocked.y) + (blocked.z + blocked.w),
                  (hidden.x + hidden.y) + (hidden.z + hidden.w));
}

// The samples of a search, whose radii grow like those of GeometricRadius(); the first is at the receiver.
struct SearchRing
{
    float reach;
    float ratio;
    float2 direction;
    float own;     // the sample's own radius
    float2 texels;
};

SearchRing FirstRing(TexelReceiver receiver, float largestRadius, int samples)
{
    SearchRing ring;
    ring.ratio = pow(max(largestRadius / kSmallestSlackTexels, 1.0), 1.0 / float(samples));
    ring.reach = kSmallestSlackTexels * ring.ratio * sqrt(ring.ratio);
    ring.direction = receiver.rotation;
    ring.own = 0.0;
    ring.texels = receiver.centre;
    return ring;
}

SearchRing NextRing(SearchRing ring, TexelReceiver receiver)
{
    SearchRing next = ring;
    next.direction = RotateDisk(ring.direction, kGoldenTurn);
    next.own = ring.reach;
    next.texels = receiver.centre + next.direction * ring.reach;
    next.reach = ring.reach * ring.ratio;
    return next;
}

// Returns which texels of a sample block in the search's cone.
bool4 BlockingInSearch(TexelQuadTest test, SearchRing ring, float depthPerTexel)
{
    return BlockingTexels(test, max(ring.own * kConePerTexel - kSmallestSlackTexels, 0.0) * depthPerTexel);
}

struct BoundedSearch
{
    float gap;         // mean gap of the blockers, stored depth
    float smallestGap;
    float largestGap;
    bool blocked;
    bool inside;       // whether any blocker is in the light's cone, and not only in the wider one
};

BoundedSearch SearchBounded(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                            float largestRadius, int samples)
{
    SearchRing ring = FirstRing(receiver, largestRadius, samples);
    float gaps = 0.0;
    float count = 0.0;
    float inside = 0.0;
    float4 smallest = float4(kNoGap, kNoGap, kNoGap, kNoGap);
    float largest = 0.0;
    UNITY_LOOP
    for (int i = 0; i < samples; ++i)
    {
        const TexelQuadTest test = TestTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, ring.texels);
        const bool4 blocking = BlockingInSearch(test, ring, depthPerTexel);
        const float4 one = blocking ? 1.0 : 0.0;
        const float4 found = test.gap * one;
        const float highest = max(max(found.x, found.y), max(found.z, found.w));
        gaps += (found.x + found.y) + (found.z + found.w);
        count += (one.x + one.y) + (one.z + one.w);
        inside = max(inside, highest - max(ring.own - kSmallestSlackTexels, 0.0) * depthPerTexel);
        smallest = min(smallest, blocking ? test.gap : kNoGap);
        largest = max(largest, highest);
        ring = NextRing(ring, receiver);
    }
    BoundedSearch search;
    search.blocked = count > 0.0;
    search.inside = inside > 0.0;
    search.gap = AverageGap(gaps, count);
    search.smallestGap = min(min(smallest.x, smallest.y), min(smallest.z, smallest.w));
    search.largestGap = largest;
    return search;
}

// In place of a search where penumbrae are known to be so narrow that the filter is the same whatever blocks: one
// layer, as wide as it may be.
BoundedSearch AnyBlockers()
{
    BoundedSearch search;
    search.blocked = true;
    search.inside = false;
    search.gap = kNoGap;
    search.smallestGap = kNoGap;
    search.largestGap = kNoGap;
    return search;
}

// The mean gaps of two layers of blockers.
struct LayerGaps
{
    float low;
    float high;
};

LayerGaps SearchLayers(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                       float largestRadius, int samples, float split)
{
    SearchRing ring = FirstRing(receiver, largestRadius, samples);
    float2 low = float2(0.0, 0.0); // x: sum of gaps, y: number of texels
    float2 high = float2(0.0, 0.0);
    UNITY_LOOP
    for (int i = 0; i < samples; ++i)
    {
        const TexelQuadTest test = TestTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, ring.texels);
        const bool4 blocking = BlockingInSearch(test, ring, depthPerTexel);
        const float4 one = blocking ? 1.0 : 0.0;
        const float4 isHigh = test.gap > split ? one : 0.0;
        const float4 isLow = one - isHigh;
        low += float2(dot(isLow, test.gap), dot(isLow, float4(1.0, 1.0, 1.0, 1.0)));
        high += float2(dot(isHigh, test.gap), dot(isHigh, float4(1.0, 1.0, 1.0, 1.0)));
        ring = NextRing(ring, receiver);
    }
    LayerGaps gaps;
    gaps.low = AverageGap(low.x, low.y);
    gaps.high = AverageGap(high.x, high.y);
    return gaps;
}

// The weights of the 4 x 4 texels around the receiver, which fall evenly with the distance.
float3 WeighNearTexels(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                       BlockerLayer layer)
{
    const float outermost = max(layer.radius, kNarrowestTexelDisc) + kBlockReachTexels;
    const float2 corner = floor(receiver.centre + 0.5);
    float3 sums = float3(0.0, 0.0, 0.0);
    UNITY_LOOP
    for (int i = 0; i < 4; ++i)
    {
        const float2 away = float2((i & 1) == 0 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
        const TexelQuadTest test = TestTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, corner + away);
        const float4 distances = DistancesOfTexels(test, receiver);
        const float4 offsets = ConeOffsets(distances, kWidestBlockTexels + kBlockReachTexels, layer.cap, depthPerTexel);
        sums += WeighTexels(max(1.0 - distances / outermost, 0.0), test, offsets, layer);
    }
    return sums;
}

// The weights of a disc of at most kWidestTexelDisc texels, by how much of each texel lies in the disc.
float3 WeighTexelDisc(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                      BlockerLayer layer)
{
    // Beyond so many quads each way no texel's square meets the disc.
    const float across = ceil(layer.radius + 0.5);
    const float2 first = floor(receiver.centre + 0.5) - across + 1.0;
    const float2 last = first + 2.0 * across - 1.0;
    float2 corner = first;
    float3 sums = float3(0.0, 0.0, 0.0);
    UNITY_LOOP
    while (corner.y < last.y)
    {
        const TexelQuadTest test = TestTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, corner);
        const float4 distances = DistancesOfTexels(test, receiver);
        const float4 offsets = ConeOffsets(distances, kQuadSlackTexels, layer.cap, depthPerTexel);
        sums += WeighTexels(min(max(layer.radius + 0.5 - distances, 0.0), 1.0), test, offsets, layer);
        corner.x += 2.0;
        if (!(corner.x < last.x)) corner = float2(first.x, corner.y + 2.0);
    }
    return sums;
}

// The weights of a disc by samples.
float3 WeighSampledDisc(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                        BlockerLayer layer, int samples)
{
    float3 sums = float3(0.0, 0.0, 0.0);
    float2 direction = receiver.rotation;
    const float perSample = 1.0 / float(samples);
    UNITY_LOOP
    for (int i = 0; i < samples; ++i)
    {
        const float reach = (layer.radius - kQuadReachTexels) * sqrt((float(i) + 0.5) * perSample);
        const float2 texels = receiver.centre + direction * reach;
        const TexelQuadTest test = TestTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, texels);
        const float offset = min(max(reach - kQuadSlackTexels + kQuadReachTexels, 0.0) * depthPerTexel, layer.cap);
        sums += WeighTexels(BilinearWeights(texels, test.corner), test, offset, layer);
        direction = RotateDisk(direction, kGoldenTurn);
    }
    return sums;
}

float3 WeighLayer(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                  BlockerLayer layer, int samples)
{
    float3 weights;
    UNITY_BRANCH
    if (layer.radius <= kWidestBlockTexels)
        weights = WeighNearTexels(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, depthPerTexel, layer);
    else if (layer.radius <= kWidestTexelDisc)
        weights = WeighTexelDisc(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, depthPerTexel, layer);
    else weights = WeighSampledDisc(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, depthPerTexel, layer, samples);
    return weights;
}

// The light that passes a low layer and the high one above it. The low one is filtered in a wider disc where next to
// nothing of it is known. Unless there are two, both are the same layer. A loop calls the filter, because FXC compiles
// what it calls once for each call.
float FilterLayers(TEXTURE2D_PARAM(shadowMap, sampler_point), TexelReceiver receiver, float depthPerTexel,
                   BlockerLayer low, BlockerLayer high, bool two, int samples)
{
    BlockerLayer layer = low;
    bool isHigh = !two;
    float visibility = 1.0;
    float3 weights = float3(0.0, 0.0, 0.0);
    int tries = 1;
    UNITY_LOOP
    for (int i = 0; i <= kLayerTries; ++i)
    {
        weights = 0.25 * weights +
                  WeighLayer(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, depthPerTexel, layer, samples);
        const bool known = weights.x + weights.y > kLeastKnown * (weights.x + weights.y + weights.z);
        if (isHigh || known || tries == kLayerTries)
        {
            visibility *= LitShare(weights.x, weights.y);
            if (isHigh || !(visibility > 0.0)) break;
            layer = high;
            isHigh = true;
            weights = float3(0.0, 0.0, 0.0);
        }
        else
        {
            layer.radius = 2.0 * layer.radius + 1.0;
            layer.cap = 0.0;
            ++tries;
        }
    }
    return visibility;
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
    const int searchSamples = BoundedSampleCount(parameters.searchSamples);
    const int filterSamples = BoundedSampleCount(parameters.filterSamples);
    BoundedSearch search = AnyBlockers();
    UNITY_BRANCH
    if (largestRadius > kWidestBlockTexels)
        search = SearchBounded(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, scales.depthPerTexel, largestRadius,
                               searchSamples);
    BoundedResult result;
    result.visibility = 1.0;
    result.radius = 0.0;
    if (!search.blocked) return result;
    BlockerLayer high = AllBlockers();
    high.radius = min(search.gap * scales.texelsPerDepth, largestRadius);
    high.cap = search.inside ? kConeHeightShare * search.gap : kNoGap;
    BlockerLayer low = high;
    const bool two = search.largestGap > kLayersApart * search.smallestGap;
    UNITY_BRANCH
    if (two)
    {
        const float split = sqrt(search.smallestGap * search.largestGap);
        const LayerGaps gaps = SearchLayers(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, scales.depthPerTexel,
                                            largestRadius, searchSamples, split);
        low.to = split;
        low.radius = min(gaps.low * scales.texelsPerDepth, largestRadius);
        low.cap = min(high.cap, kConeHeightShare * gaps.low);
        high.from = split;
        high.radius = min(gaps.high * scales.texelsPerDepth, largestRadius);
        high.cap = min(high.cap, kConeHeightShare * gaps.high);
    }
    result.radius = min(low.radius, high.radius);
    result.visibility = FilterLayers(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, scales.depthPerTexel, low,
                                     high, two, filterSamples);
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
