// Penumbra: what PCSS by angular diameter reads, for exits before it.
//
// Computes:   ExitReach of PCSS by angular diameter.
// Source:     PcssAngular.hlsl; its cone as in PcssAngularDecision.hlsl.
// Inputs:     those of the filter.
// Cost:       no fetches.
// Guarantees: those of FilterExits.hlsl.
// Use it:     with DecideExits.
#ifndef PENUMBRA_PCSS_ANGULAR_EXITS_HLSL
#define PENUMBRA_PCSS_ANGULAR_EXITS_HLSL

#include "FilterExits.hlsl"
#include "PcssAngular.hlsl"

ExitReach ReachOfPcssAngular(ShadowReceiver receiver, ShadowTile tile, PcssAngularParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const float smallest = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    const float narrowest = max(smallest, kWidestBlockTexels);
    const QuadReceiver prepared = PrepareQuads(receiver, tile);
    const float search = max(SearchRadius(prepared.depth, parameters.maxPenumbraMetres, smallest, scales), narrowest);
    ExitReach reach = ReachOfDisc(prepared, search + kSampleReachTexels);
    reach.slackTexels = smallest + kWidestSlackTexels;
    reach.depthPerTexel = scales.depthPerTexel;
    reach.largestOffset = BoundedOrLow(parameters.maxSamplingMetres, 0.0, 1e6) * scales.depthPerMetre;
    reach.radiusPerGap = scales.texelsPerDepth;
    reach.smallestRadius = narrowest;
    reach.largestRadius = search;
    reach.darkShare = kRoundedShare * kConeHeightShare;
    reach.foundAtReceiver = true;
    return reach;
}

#endif
