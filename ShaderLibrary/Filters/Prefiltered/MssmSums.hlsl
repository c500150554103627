// Penumbra: moment soft shadow mapping on summed-area tables.
//
// Computes:   visibility of a disc light: mean blocker from four moments of the area that the farthest blocker's
//             penumbra could cover, then Hamburger's bound over the area that this blocker's penumbra covers.
// Source:     Peters, Muenstermann, Wetzstein, Klein, "Improved Moment Shadow Maps for Translucent Occluders, Soft
//             Shadows and Single Scattering", JCGT 6(1), 2017. Widths are those of Core/Penumbra.hlsl.
// Inputs:     sums: of Shaders/SummedAreas.compute, of Map/DepthDigits.hlsl; ShadowReceiver; ShadowTile.
// Cost:       4 fetches for each of 1 to `searches` searches; where one finds blockers, 16 more. About 100 arithmetic
//             operations for each area.
// Guarantees: [0, 1] for any input; nothing outside of the tile counts; areas are cut off at its border.
// Use it:     for wide penumbrae where variance leaks light. Not: where three or more occluders overlap in depth.
#ifndef PENUMBRA_MSSM_SUMS_HLSL
#define PENUMBRA_MSSM_SUMS_HLSL

#include "../../Platform/Platform.hlsl"
#include "Parameters/MssmParameters.hlsl"
#include "BoxReceiver.hlsl"
#include "../../Core/BlockerMean.hlsl"
#include "../../Core/Penumbra.hlsl"
#include "../../Map/DepthDigits.hlsl"
#include "../../Map/SummedArea.hlsl"

static const float kLargestMomentReach = 0.5 * float(kLargestMomentBox) - 1.0;

// The depth of the receiver's plane in an area's middle, in the moments' range [-1, 1].
float MomentDepth(PlaneReceiver plane, MapBox box)
{
    return 2.0 * DepthAt(plane, MiddleOf(box));
}

float FilterMssmSums(Texture2D<uint4> sums, ShadowReceiver receiver, ShadowTile tile, MssmParameters parameters)
{
    const PlaneReceiver plane = PlaneReceiverOf(receiver, tile);
    const TileBounds bounds = BoundsInTexels(tile);
    const ConeScales scales = ConeScalesOf(tile);
    const float floorTexels = BoundedOrLow(parameters.minFilterTexels, 0.5, 64.0);
    const float mix = BoundedOrLow(parameters.mix, 1e-7, 0.1);
    const float receiverDepth = SanitizeReceiverDepth(receiver.shadowCoord.z);
    const float search = SearchRadius(receiverDepth, parameters.maxPenumbraMetres, floorTexels, scales);

    const int searches = min(max(parameters.searches, 1), kMostSearches);
    float radius = search;
    UNITY_LOOP
    for (int i = 0; i < searches; ++i)
    {
        const TexelBox area =
            WholeTexels(BoxInTile(plane.texels, min(radius * kBoxOfDisc, kLargestMomentReach), bounds));
        const float4 found =
            MomentsOfMomentDigits(MeanOfTexels(sums, area, int2(bounds.minimum), kMomentDigitMiddle));
        const BlockerShare blockers =
            BlockersOfMoments(found, MomentDepth(plane, BoxOf(area)), mix);
        if (!(blockers.share > kNegligibleShare)) return 1.0;
        const float searched = radius;
        const float gap = 0.5 * blockers.gapSum / blockers.share; // depths in [-1, 1] are twice as far apart
        radius = min(max(PenumbraRadius(gap, scales), floorTexels), searched);
        if (radius > kSettledShare * searched) break;
    }

    const MapBox box = BoxInTile(plane.texels, min(radius * kBoxOfDisc, kLargestMomentReach), bounds);
    const float4 moments = MomentsOfMomentDigits(MeanOfBox(sums, box, bounds, kMomentDigitMiddle));
    const float bound = HamburgerBound(moments, MomentDepth(plane, box), mix) / (1.0 - 2.0 * mix);
    return SanitizeVisibility(ReduceBleeding(bound, BoundedOrLow(parameters.bleeding, 0.0, 0.95)));
}

#endif
