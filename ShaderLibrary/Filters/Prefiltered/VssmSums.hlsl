// Penumbra: variance soft shadow mapping on summed-area tables.
//
// Computes:   visibility of a disc light: mean blocker from two moments of the area that the farthest blocker's
//             penumbra could cover, then Chebyshev's bound over the area that this blocker's penumbra covers.
// Source:     Yang, Dong, Feng, Seidel, Kautz, "Variance Soft Shadow Mapping", Pacific Graphics 2010. Widths are those
//             of Core/Penumbra.hlsl.
// Inputs:     sums: of Shaders/SummedAreas.compute, of Map/DepthDigits.hlsl; ShadowReceiver; ShadowTile.
// Cost:       4 fetches for each of 1 to `searches` searches; where one finds blockers, 16 more. 16 more each time that
//             the mean of an area lies behind the receiver though it may hold blockers: it is then divided into 3 x 3.
// Guarantees: [0, 1] for any input; nothing outside of the tile counts; areas are cut off at its border.
// Use it:     for wide penumbrae, whose width does not change the cost. Not: where occluders overlap in depth, as
//             foliage does: light leaks between them.
#ifndef PENUMBRA_VSSM_SUMS_HLSL
#define PENUMBRA_VSSM_SUMS_HLSL

#include "../../Platform/Platform.hlsl"
#include "Parameters/VssmParameters.hlsl"
#include "BoxReceiver.hlsl"
#include "../../Core/BlockerMean.hlsl"
#include "../../Core/Penumbra.hlsl"
#include "../../Map/DepthDigits.hlsl"
#include "../../Map/SummedArea.hlsl"

static const int kCellsAlong = 3;
static const float kLargestDepthReach = 0.5 * float(kLargestDepthBox) - 1.0;

struct VarianceArea
{
    float2 moments;  // moments about the receiver's plane
    float depth;     // depth of the plane in the area's middle
    float smallest;  // smallest variance
};

// The moments of an area, less the variance that the receiver's plane has there by itself.
VarianceArea AreaOfMoments(float2 moments, MapBox box, PlaneReceiver plane, float smallest)
{
    VarianceArea area;
    area.moments = float2(moments.x, moments.y - VarianceOfPlane(plane, box.high - box.low));
    area.depth = DepthAt(plane, MiddleOf(box));
    area.smallest = smallest + VarianceOfPlane(plane, float2(2.0, 2.0));
    return area;
}

bool MayHoldBlockers(VarianceArea area)
{
    return LargestBlockedShare(area.moments, area.depth, area.smallest) > kNegligibleShare;
}

struct DividedArea
{
    BlockerShare blockers;
    float visibility;
};

// The edges of 3 cells between low and high.
int4 CellEdges(int low, int high)
{
    const uint width = uint(high - low);
    return int4(low, low + int(width / 3u), low + int(2u * width / 3u), high);
}

// Chebyshev's bound holds only where the mean lies before the receiver. Each of 3 x 3 cells is judged by itself; those
// whose mean lies behind count as lit.
DividedArea Divide(Texture2D<uint4> sums, TexelBox box, int2 tileLow, PlaneReceiver plane, float smallest)
{
    const int4 x = CellEdges(box.low.x, box.high.x);
    const int4 y = CellEdges(box.low.y, box.high.y);
    DividedArea divided;
    divided.blockers.share = 0.0;
    divided.blockers.gapSum = 0.0;
    divided.visibility = 0.0;
    SumRow above = SumsBefore(sums, x, y.x, tileLow);
    int top = y.x;
    int3 bottoms = y.yzw;
    // Only the rows are a loop, because Unity's compiler takes seconds over nine cells.
    UNITY_LOOP
    for (int row = 0; row < kCellsAlong; ++row)
    {
        const SumRow below = SumsBefore(sums, x, bottoms.x, tileLow);
        UNITY_UNROLL
        for (int column = 0; column < kCellsAlong; ++column)
        {
            TexelBox cell;
            cell.low = int2(x[column], top);
            cell.high = int2(x[column + 1], bottoms.x);
            const int2 size = cell.high - cell.low;
            const uint4 sum = below.at[column + 1] - below.at[column] - above.at[column + 1] + above.at[column];
            const float share = AreaOf(cell) / AreaOf(box);
            const float4 mean = CentredSum(sum, kDepthDigitMiddle, size.x * size.y) / max(AreaOf(cell), 1.0);
            const VarianceArea area = AreaOfMoments(MomentsOfDigits(mean), BoxOf(cell), plane, smallest);
            const BlockerShare blockers = BlockersOfVariance(area.moments, area.depth, area.smallest);
            divided.blockers.share += share * blockers.share;
            divided.blockers.gapSum += share * blockers.gapSum;
            divided.visibility += share * (1.0 - blockers.share);
        }
        above = below;
        top = bottoms.x;
        bottoms = bottoms.yzz;
    }
    return divided;
}

BlockerShare SearchVariance(Texture2D<uint4> sums, PlaneReceiver plane, TileBounds bounds, float radius,
                            float smallest)
{
    const float reach = min(radius * kBoxOfDisc, kLargestDepthReach);
    const TexelBox box = WholeTexels(BoxInTile(plane.texels, reach, bounds));
    const float4 mean = MeanOfTexels(sums, box, int2(bounds.minimum), kDepthDigitMiddle);
    const VarianceArea area = AreaOfMoments(MomentsOfDigits(mean), BoxOf(box), plane, smallest);
    BlockerShare blockers = BlockersOfVariance(area.moments, area.depth, area.smallest);
    UNITY_BRANCH
    if (!(blockers.gapSum > 0.0) && MayHoldBlockers(area))
        blockers = Divide(sums, box, int2(bounds.minimum), plane, smallest).blockers;
    return blockers;
}

float FilterVssmSums(Texture2D<uint4> sums, ShadowReceiver receiver, ShadowTile tile, VssmParameters parameters)
{
    const PlaneReceiver plane = PlaneReceiverOf(receiver, tile);
    const TileBounds bounds = BoundsInTexels(tile);
    const ConeScales scales = ConeScalesOf(tile);
    const float floorTexels = BoundedOrLow(parameters.minFilterTexels, 0.5, 64.0);
    const float smallest = BoundedOrLow(parameters.smallestVariance, 1e-7, 1e-2);
    const float receiverDepth = SanitizeReceiverDepth(receiver.shadowCoord.z);
    const float search = SearchRadius(receiverDepth, parameters.maxPenumbraMetres, floorTexels, scales);

    const int searches = min(max(parameters.searches, 1), kMostSearches);
    float radius = search;
    UNITY_LOOP
    for (int i = 0; i < searches; ++i)
    {
        const BlockerShare blockers = SearchVariance(sums, plane, bounds, radius, smallest);
        if (!(blockers.share > kNegligibleShare)) return 1.0;
        const float searched = radius;
        radius = min(max(PenumbraRadius(blockers.gapSum / blockers.share, scales), floorTexels), searched);
        if (radius > kSettledShare * searched) break;
    }

    const MapBox box = BoxInTile(plane.texels, min(radius * kBoxOfDisc, kLargestDepthReach), bounds);
    const float2 moments = MomentsOfDigits(MeanOfBox(sums, box, bounds, kDepthDigitMiddle));
    const VarianceArea area = AreaOfMoments(moments, box, plane, smallest);
    float visibility = ChebyshevBound(area.moments, area.depth, area.smallest);
    UNITY_BRANCH
    if (!(area.depth > area.moments.x) && MayHoldBlockers(area))
        visibility = Divide(sums, WholeTexels(box), int2(bounds.minimum), plane, smallest).visibility;
    return SanitizeVisibility(ReduceBleeding(visibility, BoundedOrLow(parameters.bleeding, 0.0, 0.95)));
}

#endif
