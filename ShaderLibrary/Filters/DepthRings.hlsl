// Penumbra: blockers around a receiver, by cells of the shadow map that grow with their distance.
//
// Computes:   ShareInRing, BlockersOfTexel, BlockersOfCell, AddBlockers: the share of a cell that belongs to the ring of its level, how much of a cell blocks and how far above the
//             receiver, and with their sums the mean radius of the penumbrae that all blockers make.
//
//                 +-------+-------+-------+   cells of one texel up to kRingCells texels from the receiver, of two texels
//                 |       +-+-+-+-+       |   up to twice as far, and so on: each octave of distance has as many cells,
//                 |       +-+-o-+-+       |   so that a low blocker, whose penumbra is narrow, is seen as sharply in
//                 +-------+-+-+-+-+-------+   proportion as a high one
//
// Source:     Penumbra's own. A cell with the mean m above the receiver's plane and the deviation s is taken for a share f at
//             the height h, the rest on the plane itself: f h = m, f h^2 = m^2 + s^2. Weighting each blocker by area / r^2,
//             r its penumbra's radius, weights it by the share of the light's disc that it hides.
// Inputs:     QuadReceiver; ConeScales; lengths in texels, depths as stored.
// Cost:       no fetches.
// Guarantees: finite; a cell without anything above the plane blocks nothing. The rings' shares of a cell's levels are in
//             [0, 1].
// Use it:     over cells in groupshared memory. Not: under spot lights.
#ifndef PENUMBRA_DEPTH_RINGS_HLSL
#define PENUMBRA_DEPTH_RINGS_HLSL

#include "../Map/DepthSpread.hlsl"
#include "TexelQuad.hlsl"

// From the receiver to where the next level begins, in cells. With 2 the error in penumbrae is 1 to 4 % larger, for 3 to 15 %
// fewer fetches (street, trees and garden, 0.53, 2 and 5 degrees).
static const float kRingCells = 3.0;
// A mean that lies above the plane by less is on it: two steps of 16 bits.
static const float kLeastAbove = 3e-5;
// How many times as wide as the light's cone the search looks where the cone is empty, as in PcssAngular.hlsl.
static const float kNearbyCones = 5.0;

// What lies in a cell above the receiver's plane: a share of its area, and how much nearer to the light than the receiver.
struct CellBlockers
{
    float share;
    float gap;
};

// distance: of the cell's centre. radius: beyond which no cell counts.
float ShareInRing(float distance, int level, float radius)
{
    const float cell = exp2(float(level));
    const float share = min(max((min(kRingCells * cell, radius) - distance) / cell + 0.5, 0.0), 1.0);
    if (level == 0) return share;
    const float inner = 0.5 * cell;
    return share * (1.0 - min(max((min(kRingCells * inner, radius) - distance) / inner + 0.5, 0.0), 1.0));
}

// The smallest number of levels beyond the first whose rings reach `radius`, at most `most`.
int RingLevels(float radius, int most)
{
    return int(min(ceil(log2(max(radius / kRingCells, 1.0))), float(most)));
}

float PlaneDepth(QuadReceiver receiver, float2 away)
{
    return KeepBehindNearPlane(receiver.depth + dot(receiver.gradient, away));
}

CellBlockers BlockersOfTexel(float depth, float2 away, QuadReceiver receiver)
{
    CellBlockers blockers;
    blockers.gap = DepthGap(depth, receiver.depth);
    blockers.share = DepthGap(depth, PlaneDepth(receiver, away)) > 0.0 && blockers.gap > 0.0 ? 1.0 : 0.0;
    return blockers;
}

// cell: its width, texels.
CellBlockers BlockersOfCell(DepthSpread spread, float2 away, float cell, QuadReceiver receiver)
{
    CellBlockers blockers;
    blockers.share = 0.0;
    blockers.gap = 0.0;
    const float plane = PlaneDepth(receiver, away);
    const float above = DepthGap(spread.mean, plane);
    if (!(above > kLeastAbove)) return blockers;
    // The plane itself spreads over the cell, too.
    const float slope = dot(receiver.gradient, receiver.gradient) * cell * cell / 12.0;
    const float square = above * above + max(spread.deviation * spread.deviation - slope, 0.0);
    blockers.gap = square / above + DepthGap(plane, receiver.depth);
    blockers.share = blockers.gap > 0.0 ? above * above / square : 0.0;
    return blockers;
}

// Over all cells: of those in the light's cone, and of those in a cone kNearbyCones as wide.
struct RingSums
{
    float2 inside; // x: area / r^2; y: area / r
    float2 nearby;
};

RingSums NoBlockers()
{
    RingSums sums;
    sums.inside = float2(0.0, 0.0);
    sums.nearby = float2(0.0, 0.0);
    return sums;
}

// area: of the cell, in its ring.
RingSums AddBlockers(RingSums sums, CellBlockers blockers, float distance, float cell, float area, ConeScales scales)
{
    RingSums next = sums;
    const float own = blockers.gap * scales.texelsPerDepth;
    const float radius = max(own, 1.0);
    const float blocked = area * blockers.share;
    const float inside = blocked * min(max((radius - distance) / cell + 0.5, 0.0), 1.0);
    const float nearby = blocked * min(max((max(kNearbyCones * own, 1.0) - distance) / cell + 0.5, 0.0), 1.0);
    next.inside += inside * float2(1.0 / (radius * radius), 1.0 / radius);
    next.nearby += nearby * float2(1.0 / (radius * radius), 1.0 / radius);
    return next;
}

#endif
