// Penumbra: what percentage-closer soft shadows read, for exits before them.
//
// Computes:   ExitReach of PCSS by angular diameter, of the classic recipe, of HDRP's rules and of the single loop.
// Source:     PcssAngular.hlsl, PcssClassic.hlsl, PcssHdrp.hlsl, SingleLoop.hlsl.
// Inputs:     those of the filters.
// Cost:       no fetches.
// Guarantees: those of FilterExits.hlsl.
// Use it:     with DecideExits.
#ifndef PENUMBRA_PCSS_EXITS_HLSL
#define PENUMBRA_PCSS_EXITS_HLSL

#include "FilterExits.hlsl"
#include "PcssAngular.hlsl"
#include "PcssClassic.hlsl"
#include "PcssHdrp.hlsl"
#include "SingleLoop.hlsl"

// Of the mean gap, with what floats round of it.
static const float kRoundedShare = 1.001;

// Its cone as in PcssAngularDecision.hlsl.
ExitReach ReachOfPcssAngular(ShadowReceiver receiver, ShadowTile tile, PcssAngularParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const float smallest = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    const float narrowest = max(smallest, kWidestBlockTexels);
    const QuadReceiver prepared = PrepareQuads(receiver, tile);
    const float search = max(SearchRadius(prepared.depth, parameters.maxPenumbraMetres, smallest, scales), narrowest);
    ExitReach reach = ReachOfDisc(prepared, search + kSampleReachTexels);
    reach.slackTexels = smallest + 1.75;
    reach.depthPerTexel = scales.depthPerTexel;
    reach.largestOffset = BoundedOrLow(parameters.maxSamplingMetres, 0.0, 1e6) * scales.depthPerMetre;
    reach.radiusPerGap = scales.texelsPerDepth;
    reach.smallestRadius = narrowest;
    reach.largestRadius = search;
    reach.darkShare = kRoundedShare * kConeHeightShare;
    reach.foundAtReceiver = true;
    return reach;
}

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
