// Penumbra: the receiver that stands for those of a part of 4 x 4 pixels, and what all threads of the part find around
// it.
//
// Computes:   which of the part's receivers it is; whether others are near enough to its plane to take its sums.
// Source:     Penumbra's own.
// Inputs:     receivers, one for each thread; TileClusters.hlsl.
// Cost:       no fetches. 56 bytes of groupshared memory for each part.
// Guarantees: the same receivers give the same one, whatever the order of the threads.
// Use it:     in kernels of WINDOW_THREADS threads, PART_LANES neighbouring ones for each part; a barrier between
//             ResetPart, OfferLane, IsLaneOfPart with PutPlane, and what reads the plane.
#ifndef PENUMBRA_TILE_PARTS_HLSL
#define PENUMBRA_TILE_PARTS_HLSL

#include "TileClusters.hlsl"
#include "../Filters/Cells/CellRings.hlsl"

// A receiver takes the sums of its part's receiver if it is this near to that one's plane, texels along the light, and
// this near to it.
static const float kPartPlaneTexels = 2.0;
static const float kPartReach = 12.0;

// Each part has one of these: the number of the receiver whose sums the others take.
groupshared uint partLane[TILE_PARTS];
groupshared float4 partPlane[TILE_PARTS]; // xy: centre, zw: gradient
groupshared float2 partDepth[TILE_PARTS]; // x: depth, y: radius of the search
groupshared uint partSums[TILE_PARTS * 4]; // inside and nearby of RingSums, in steps
groupshared uint partGround[TILE_PARTS]; // depth of the ground for BlockersOfCell
groupshared uint partSpread[TILE_PARTS]; // distance of the farthest receiver along an axis, texels
groupshared uint partNear[TILE_PARTS];   // 1: a texel near the receivers makes a narrow penumbra

void ResetPart(uint part, uint lane)
{
    if (lane < 4) partSums[4 * part + lane] = 0;
    if (lane == 0)
    {
        partLane[part] = PART_LANES;
        partGround[part] = 0x7f7fffffu;
        partSpread[part] = 0;
        partNear[part] = 0;
    }
}

// Threads are taken in order from the part's middle.
uint LaneOrder(uint lane)
{
    return (lane + PART_LANES - 5) % PART_LANES;
}

void OfferLane(uint part, uint lane)
{
    InterlockedMin(partLane[part], LaneOrder(lane));
}

// Whether this thread is the one that was chosen of those that offered themselves.
bool IsLaneOfPart(uint part, uint lane)
{
    return LaneOrder(lane) == partLane[part];
}

// radius is the search's, texels.
void PutPlane(QuadReceiver receiver, float radius, uint part)
{
    partPlane[part] = float4(receiver.centre, receiver.gradient);
    partDepth[part] = float2(receiver.depth, radius);
}

// The receiver of the part whose sums the others take; `like` is any receiver of the same tile.
QuadReceiver ReceiverOfPart(uint part, QuadReceiver like)
{
    QuadReceiver receiver = like;
    receiver.centre = partPlane[part].xy;
    receiver.gradient = partPlane[part].zw;
    receiver.depth = partDepth[part].x;
    return receiver;
}

// Whether the receiver is near enough to the part's to take its sums.
bool IsNearPart(QuadReceiver receiver, ConeScales scales, uint part)
{
    const QuadReceiver other = ReceiverOfPart(part, receiver);
    const float2 away = receiver.centre - other.centre;
    const float beside = abs(receiver.depth - PlaneDepth(other, away));
    return beside <= kPartPlaneTexels * UsualGround(scales) && max(abs(away.x), abs(away.y)) <= kPartReach;
}

float GroundOfPart(uint part, ConeScales scales)
{
    const float found = asfloat(partGround[part]);
    return found < kDeepestGround * UsualGround(scales) ? found : UsualGround(scales);
}

#endif
