// Penumbra: what percentage-closer soft shadows read, for exits before them.
//
// Computes:   ExitReach of PCSS by the classic recipe, by HDRP's rules and of the single loop; with PcssAngularExits.hlsl.
// Source:     PcssClassic.hlsl, PcssHdrp.hlsl, SingleLoop.hlsl.
// Inputs:     those of the filters.
// Cost:       no fetches.
// Guarantees: those of FilterExits.hlsl.
// Use it:     with DecideExits.
#ifndef PENUMBRA_PCSS_EXITS_HLSL
#define PENUMBRA_PCSS_EXITS_HLSL

#include "PcssAngularExits.hlsl"
#include "PcssClassic.hlsl"
#include "PcssHdrp.hlsl"
#include "SingleLoop.hlsl"

ExitReach ReachOfPcssClassic(ShadowReceiver receiver, ShadowTile tile, PcssClassicParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const float smallest = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    const float search = min(max(BoundedOrLow(parameters.searchRadiusMetres, 0.0, 1e6) * scales.texelsPerMetre, smallest),
                             scales.largestRadius);
    ExitReach reach = ReachOfDisc(PrepareQuads(receiver, tile), search + kSampleReachTexels);
    reach.radiusPerGap = scales.texelsPerDepth;
    reach.smallestRadius = smallest;
    reach.largestRadius = max(scales.largestRadius, smallest);
    return reach;
}

// The search's cone without slack: a sample lies in the square of the texel that it reads.
ExitReach ReachOfPcssHdrp(ShadowReceiver receiver, ShadowTile tile, PcssHdrpParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const HdrpScales hdrp = HdrpScalesOf(scales, parameters);
    const QuadReceiver prepared = PrepareQuads(receiver, tile);
    const float smallest = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    const float gap = min(LargestGap(prepared.depth), hdrp.largestBlockerGap);
    const float search = min(max(gap * hdrp.texelsPerDepth, smallest), scales.largestRadius);
    ExitReach reach = FlatReachOfDisc(prepared, search + kSampleReachTexels);
    reach.slackTexels = 1e-2;
    reach.depthPerTexel = hdrp.searchDepthPerTexel;
    reach.largestOffset = hdrp.largestOffset;
    reach.radiusPerGap = hdrp.texelsPerDepth;
    reach.smallestRadius = smallest;
    reach.largestRadius = search;
    reach.darkShare = kRoundedShare * 0.25;
    reach.foundAtReceiver = true;
    return reach;
}

ExitReach ReachOfSingleLoop(ShadowReceiver receiver, ShadowTile tile, SingleLoopParameters parameters)
{
    const SingleLoop loop = PrepareSingleLoop(receiver, tile, parameters);
    return ReachOfDisc(loop.receiver, loop.radius + kTapToCentreTexels);
}

#endif
