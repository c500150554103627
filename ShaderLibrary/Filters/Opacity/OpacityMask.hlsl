// Penumbra: how much of the light blended casters stop.
//
// Computes:   OpacityAtReceiver  the mask at the receiver
//             OpacityOverDisc    its mean over the disc of the penumbra that the blended casters make:
//
//                  \  disc of angular diameter a  /
//                   \        |--w--|             /    w = tan(a/2) gap: what the cone of rays to the light covers at
//              .. .. \ .. .. .. .. / .. blended       the casters. The mean of their opacity over it is the share of
//                     \      |gap /                   the light that they stop.
//                      \     |   /
//                 ------\----+--/-------- receiver
//
// Source:     Candycat, "Graphics Study: RDR2, shadows" (2021), for the mask and its one sample. The disc: Fernando,
//             "Percentage-Closer Soft Shadows" (2005), with the mean gap weighted by opacity.
// Inputs:     opacityMask: 1 less the product of transmittances; blendedDepth: the nearest depth of what is in it; both
//             of the map's size (Shaders/OpacityPasses.hlsl). AngularSearch: PcssAngular.hlsl.
// Cost:       at the receiver 1 fetch. Over the disc a gather of the mask for each tap, and one of the depth where any
//             of its texels has opacity: a third of blockerSamples for the search, and where it finds anything
//             filterSamples more.
// Guarantees: [0, 1] for any input; exactly 0 where the mask is 0; texels outside the tile are not read. Over the disc,
//             texels whose nearest blended caster is not above the receiver count as 0.
// Use it:     multiply a filter's visibility by 1 less it. Not: between two blended casters over one texel: the mask
//             has both.
#ifndef PENUMBRA_OPACITY_MASK_HLSL
#define PENUMBRA_OPACITY_MASK_HLSL

#include "../Pcss/PcssAngular.hlsl"

// The search needs fewer taps than that for blockers: each tap sees four texels, and smoke has no holes. With 4, 8, 12
// and 24 taps the error in penumbra of the scene wires-and-smoke under a disc of 2 degrees is 0.061, 0.051, 0.047 and
// 0.044, for 36, 42, 47 and 61 fetches.
static const int kBlockerSamplesPerTap = 3;

struct BlendedQuad
{
    float4 opacity; // opacity above the receiver
    float4 gap;     // stored depth
    float4 radius;  // distance from the receiver, texels
    float4 weight;  // bilinear weight
};

float4 BoundedOpacity(float4 opacity)
{
    return float4(BoundedOrLow(opacity.x, 0.0, 1.0), BoundedOrLow(opacity.y, 0.0, 1.0),
                  BoundedOrLow(opacity.z, 0.0, 1.0), BoundedOrLow(opacity.w, 0.0, 1.0));
}

float OpacityAtReceiver(TEXTURE2D_PARAM(opacityMask, sampler_linear), ShadowReceiver receiver, ShadowTile tile)
{
    const float2 texels = ClampFootprint(TexelCoordinates(receiver.shadowCoord.xy, tile), BoundsInTexels(tile));
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    return BoundedOrLow(SAMPLE_TEXTURE2D_LOD(opacityMask, sampler_linear, texels / size, 0).x, 0.0, 1.0);
}

BlendedQuad ReadBlended(TEXTURE2D(opacityMask), TEXTURE2D_PARAM(blendedDepth, sampler_point), QuadReceiver receiver,
                        float2 texels)
{
    const float2 corner = ClampQuadCorner(texels, receiver.bounds);
    const float2 coordinate = corner * receiver.texelSize;
    const float2 away = corner - receiver.centre;
    const float4 x = away.x + float4(-0.5, 0.5, 0.5, -0.5);
    const float4 y = away.y + float4(0.5, 0.5, -0.5, -0.5);
    BlendedQuad quad;
    quad.opacity = BoundedOpacity(GATHER_RED_TEXTURE2D(opacityMask, sampler_point, coordinate));
    quad.gap = float4(0.0, 0.0, 0.0, 0.0);
    quad.radius = sqrt(x * x + y * y);
    quad.weight = BilinearWeights(texels, corner);
    UNITY_BRANCH
    if (any(quad.opacity > 0.0))
    {
        const float4 depth = SanitizeMapDepth(GATHER_RED_TEXTURE2D(blendedDepth, sampler_point, coordinate));
        quad.gap = DepthGap(depth, float4(receiver.depth, receiver.depth, receiver.depth, receiver.depth));
        quad.opacity *= float4(quad.gap > 0.0);
    }
    return quad;
}

// The mean gap of the blended casters above the receiver, weighted by opacity, in the light's cone or, where it is
// empty, in a wider one. The estimate's count is the sum of opacities, 0 where there are none.
BlockerEstimate SearchBlended(TEXTURE2D(opacityMask), TEXTURE2D_PARAM(blendedDepth, sampler_point),
                              AngularSearch search, int samples, float clump)
{
    const int count = BoundedSampleCount(samples);
    LightCone wide = search.cone;
    wide.scales.depthPerTexel = search.cone.scales.depthPerTexel / kNearbyWidth;
    const float4 each = float4(1.0, 1.0, 1.0, 1.0);
    float2 inside = float2(0.0, 0.0); // x: sum of gaps, y: sum of opacities
    float2 nearby = float2(0.0, 0.0);
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        const float reach = i == 0 ? 0.0 : SearchSampleRadius(i, count, clump, search.radius);
        const float2 offset = RotateDisk(FibonacciDirection(i), search.rotation) * reach;
        const BlendedQuad quad = ReadBlended(opacityMask, TEXTURE2D_ARGS(blendedDepth, sampler_point), search.receiver,
                                             search.receiver.centre + offset);
        const float4 hit = quad.opacity * TexelsInCone(quad.gap, quad.gap, quad.radius, search.cone);
        const float4 close = quad.opacity * TexelsInCone(quad.gap, quad.gap, quad.radius, wide);
        inside += float2(dot(quad.gap, hit), dot(hit, each));
        nearby += float2(dot(quad.gap, close), dot(close, each));
    }
    const float2 found = inside.y > 0.0 ? inside : nearby;
    BlockerEstimate estimate;
    estimate.gap = AverageGap(found.x, found.y);
    estimate.count = found.y;
    return estimate;
}

float OpacityOverDisc(TEXTURE2D(opacityMask), TEXTURE2D_PARAM(blendedDepth, sampler_point), AngularSearch search,
                      PcssAngularParameters parameters)
{
    const BlockerEstimate casters =
        SearchBlended(opacityMask, TEXTURE2D_ARGS(blendedDepth, sampler_point), search,
                      parameters.blockerSamples / kBlockerSamplesPerTap,
                      BoundedOrLow(parameters.blockerClump, 0.0, 8.0));
    if (!(casters.count > 0.0)) return 0.0;
    const float penumbra = min(PenumbraRadius(casters.gap, search.cone.scales), search.radius);
    const float radius = max(penumbra - kQuadReachTexels, search.smallestRadius);
    const int count = BoundedSampleCount(parameters.filterSamples);
    float sum = 0.0;
    float weights = 0.0;
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        const float2 offset = RotateDisk(FibonacciDisk(i, count, 1.0), search.rotation) * radius;
        const BlendedQuad quad = ReadBlended(opacityMask, TEXTURE2D_ARGS(blendedDepth, sampler_point), search.receiver,
                                             search.receiver.centre + offset);
        sum += dot(quad.weight, quad.opacity);
        weights += dot(quad.weight, float4(1.0, 1.0, 1.0, 1.0));
    }
    return weights > 0.0 ? BoundedOrLow(sum / weights, 0.0, 1.0) : 0.0;
}

#endif
