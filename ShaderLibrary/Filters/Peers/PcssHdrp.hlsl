// Penumbra: PCSS with the parameters of Unity's HDRP, to match its look.
//
// Computes:   what HDRP's directional PCSS computes from its own parameters: its scale of depth to radius, which is
//             twice the geometric one, its caps and its floors. Penumbrae come out about twice as wide as the light's
//             disc makes them; PcssAngular.hlsl has the geometric width.
// Source:     the parameters and rules of HDRP's directional PCSS, rebuilt from their documentation:
//             radius = tan(a/2) |m00 / m22| gap with m the device projection (depth 0..1).
// Inputs:     shadow map (raw reads; the comparison sampler is not used), point sampler; ShadowReceiver; ShadowTile;
//             PcssHdrpParameters. The receiver's plane is not used, as in HDRP.
// Cost:       blockerSamples fetches where nothing blocks, else blockerSamples + filterSamples.
// Guarantees: [0, 1] for any input; exactly 1 without blockers; texels outside the tile do not count.
// Use it:     when a scene lit for HDRP must look the same. Not: when the light's angular diameter must be exact.
#ifndef PENUMBRA_PCSS_HDRP_HLSL
#define PENUMBRA_PCSS_HDRP_HLSL

#include "../Taps/DepthTaps.hlsl"
#include "../../Core/Disk.hlsl"
#include "Parameters/PcssHdrpParameters.hlsl"

// |m00 / m22| of a depth range 0..1 is 2 |row0| / |row2| of the world-to-tile matrix.
static const float kHdrpScale = 2.0;

// HDRP's per-cascade constants, in texels and stored depth.
struct HdrpScales
{
    float texelsPerDepth;        // scale of the light's cone
    float depthPerTexel;         // its inverse
    float searchDepthPerTexel;   // scale of the wider cone of the blocker search
    float minFilterDepthPerTexel; // scale of the cone below the smallest filter radius
    float largestBlockerGap;
    float largestOffset;
};

float DepthPerTexelOf(float tanHalf, ConeScales scales)
{
    const float texels = kHdrpScale * tanHalf * scales.texelsPerMetre;
    return texels > 0.0 ? scales.depthPerMetre / texels : 0.0;
}

HdrpScales HdrpScalesOf(ConeScales scales, PcssHdrpParameters parameters)
{
    HdrpScales hdrp;
    hdrp.texelsPerDepth = kHdrpScale * scales.texelsPerDepth;
    hdrp.depthPerTexel = scales.depthPerTexel / kHdrpScale;
    hdrp.searchDepthPerTexel = DepthPerTexelOf(BoundedOrLow(parameters.searchTanHalf, 0.0, 1e3), scales);
    hdrp.minFilterDepthPerTexel = DepthPerTexelOf(BoundedOrLow(parameters.minFilterTanHalf, 0.0, 1e3), scales);
    // A penumbra of maxPenumbraMetres is made by a gap of maxPenumbra / (2 tan(a/2)) metres. The tile has no
    // field for tan(a/2) itself; it is texels per depth / texels per metre * depth per metre.
    const float tanHalfPerDepth = scales.texelsPerMetre > 0.0 ? scales.texelsPerDepth / scales.texelsPerMetre : 0.0;
    hdrp.largestBlockerGap = tanHalfPerDepth > 0.0
        ? BoundedOrLow(parameters.maxPenumbraMetres, 0.0, 1e6) * 0.5 / tanHalfPerDepth : 1.0;
    hdrp.largestOffset = BoundedOrLow(parameters.maxSamplingMetres, 0.0, 1e6) * scales.depthPerMetre;
    return hdrp;
}

BlockerEstimate HdrpSearch(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, HdrpScales hdrp,
                           float2 rotation, float radius, PcssHdrpParameters parameters)
{
    const int count = BoundedSampleCount(parameters.blockerSamples);
    const float clump = BoundedOrLow(parameters.blockerClump, 1.0, 8.0);
    float gapSum = 0.0;
    BlockerEstimate estimate;
    estimate.count = 0.0;
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        // As in HDRP the spiral starts at its centre. That tap is kept inside the tile; others outside do not count.
        const float spread = pow(abs(float(i) / float(count)), 0.5 * clump);
        const float2 offset = RotateDisk(FibonacciDirection(i) * spread, rotation) * radius;
        const float2 texels = i == 0 ? ClampToTile(receiver.centre, receiver.bounds) : receiver.centre + offset;
        if (InTile(texels, receiver.bounds))
        {
            const float mapDepth = PointDepth(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, texels);
            const float gap = DepthGap(mapDepth, receiver.depth);
            if (gap > min(length(offset) * hdrp.searchDepthPerTexel, hdrp.largestOffset))
            {
                gapSum += gap;
                estimate.count += 1.0;
            }
        }
    }
    estimate.gap = AverageGap(gapSum, estimate.count);
    return estimate;
}

float FilterPcssHdrp(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                     ShadowReceiver receiver, ShadowTile tile, PcssHdrpParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const HdrpScales hdrp = HdrpScalesOf(scales, parameters);
    const QuadReceiver prepared = PrepareQuads(receiver, tile);
    const float2 rotation = UnitRotation(receiver.rotation);
    const float smallestRadius = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);

    const float reach = min(LargestGap(prepared.depth), hdrp.largestBlockerGap);
    const float searchRadius = min(max(reach * hdrp.texelsPerDepth, smallestRadius), scales.largestRadius);
    const BlockerEstimate blockers =
        HdrpSearch(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, hdrp, rotation, searchRadius, parameters);
    if (!(blockers.count > 0.0)) return 1.0;

    const float gap = min(blockers.gap, hdrp.largestBlockerGap);
    const float radius = min(max(gap * hdrp.texelsPerDepth, smallestRadius), scales.largestRadius);
    const float largestOffset = min(hdrp.largestOffset, 0.25 * gap);
    const int count = BoundedSampleCount(parameters.filterSamples);
    float lit = 0.0;
    float taken = 0.0;
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        const float2 offset = RotateDisk(FibonacciDisk(i, count, 1.0), rotation) * radius;
        const float lateral = length(offset);
        if (InTile(prepared.centre + offset, prepared.bounds))
        {
            const float perTexel = lateral < smallestRadius ? hdrp.minFilterDepthPerTexel : hdrp.depthPerTexel;
            const float reference =
                KeepBehindNearPlane(MoveTowardLight(prepared.depth, min(lateral * perTexel, largestOffset)));
            lit += LitByGather(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, prepared.centre + offset, reference);
            taken += 1.0;
        }
    }
    // If every tap lies outside the tile, the receiver's own texel decides.
    if (!(taken > 0.0))
    {
        return LitByGather(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, prepared.centre,
                           KeepBehindNearPlane(prepared.depth));
    }
    return SanitizeVisibility(MeanVisibility(lit, taken));
}

#endif
