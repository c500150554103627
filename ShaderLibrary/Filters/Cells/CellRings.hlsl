// Penumbra: blockers around a receiver, by cells of the shadow map that grow with their distance.
//
// Computes:   ShareInRing: the share of a cell that belongs to the ring of its level; BlockersOfTexel, BlockersOfCell:
//             how much of it blocks, and how far above the receiver; AddBlockers: sums, for the mean radius of the
//             penumbrae that all blockers make.
//
//                 +-------+-------+-------+   cells of one texel up to ringCells texels from the receiver, of 2 texels
//                 |       +-+-+-+-+       |   up to twice as far, and so on: each octave of distance has as many cells,
//                 |       +-+-o-+-+       |   so that a low blocker, whose penumbra is narrow, is seen as sharply in
//                 +-------+-+-+-+-+-------+   proportion as a high one
//
// Source:     Penumbra's own. A cell with the mean m above the ground and the deviation s is taken for a share f at the
//             height h above it, the rest on the ground: f h = m, f h^2 = m^2 + s^2. Were the ground taken to lie on
//             the receiver's plane, which is above it by the casters' bias, a small share of blockers would be far too
//             high. Weighting each blocker by area / r^2, r its penumbra's radius, weights it by the share of the
//             light's disc that it hides.
// Inputs:     QuadReceiver; ConeScales; lengths in texels, depths as stored.
// Cost:       no fetches.
// Guarantees: finite; a cell without anything above the plane blocks nothing. The rings' shares of a cell's levels are
//             in [0, 1].
// Use it:     over the cells around a receiver, CellSums.hlsl. Not: under spot lights.
#ifndef PENUMBRA_CELL_RINGS_HLSL
#define PENUMBRA_CELL_RINGS_HLSL

#include "../../Core/PowersOfTwo.hlsl"
#include "../../Map/DepthSpread.hlsl"
#include "../Taps/TexelQuad.hlsl"

// The distance from the receiver to where the next level begins, in cells of the level: one number for the filter, and
// one for the search, whose mean changes less with the size of cells. Other numbers can be defined before this file, to
// measure them (Documentation~/screen-passes.md).
#if !defined(PENUMBRA_RING_CELLS)
#define PENUMBRA_RING_CELLS 5.0
#endif
#if !defined(PENUMBRA_SEARCH_RING_CELLS)
#define PENUMBRA_SEARCH_RING_CELLS 3.0
#endif
static const float kRingCells = PENUMBRA_RING_CELLS;
static const float kSearchRingCells = PENUMBRA_SEARCH_RING_CELLS;
// A mean that lies above the ground by less than this counts as on it: four steps of 16 bits. So does one that lies
// above it by less than the next share of how far the receiver's plane rises from the receiver to the cell, because the
// plane's slope comes from the camera's depths.
static const float kLeastAbove = 6e-5;
static const float kSlopeError = 0.03;
// The share by which the squared deviation of a plane may be larger than that of the receiver's plane, and the error of
// a deviation.
static const float kSquareError = 0.1;
static const float kDeviationError = 2e-5;
// The ground lies below the receiver's plane by the bias with which casters are drawn. It is looked for up to this many
// texels away, and this many texels deep.
static const float kGroundReach = 2.5;
static const float kDeepestGround = 8.0;
// The search looks in a cone this many times as wide as the light's where the light's cone is empty, as in
// PcssAngular.hlsl.
static const float kNearbyCones = 5.0;

// The part of a cell that lies above the receiver's plane: the share of the cell's area that it takes, and how much
// nearer to the light than the receiver it is.
struct CellBlockers
{
    float share;
    float gap;
};

// The share of a cell that belongs to the level's ring and what the ring encloses. distance is that of the cell's
// centre. No cell beyond radius counts. ringCells is kRingCells or kSearchRingCells.
float ShareInDisc(float distance, int level, float radius, float ringCells)
{
    const float cell = PowerOfTwo(level);
    return min(max((min(ringCells * cell, radius) - distance) / cell + 0.5, 0.0), 1.0);
}

float ShareInRing(float distance, int level, float radius, float ringCells)
{
    const float share = ShareInDisc(distance, level, radius, ringCells);
    if (level == 0) return share;
    return share * (1.0 - ShareInDisc(distance, level - 1, radius, ringCells));
}

// The smallest number of levels beyond the first whose rings reach `radius`, at most `most`.
int RingLevels(float radius, float ringCells, int most)
{
    return min(CeilLog2(max(radius / ringCells, 1.0)), most);
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

// cell is the cell's width, texels. ground is how far the ground lies below the receiver's plane, stored depth.
CellBlockers BlockersOfCell(DepthSpread spread, float2 away, float cell, float ground, QuadReceiver receiver)
{
    CellBlockers blockers;
    blockers.share = 0.0;
    blockers.gap = 0.0;
    const float plane = PlaneDepth(receiver, away);
    const float above = DepthGap(spread.mean, plane) + ground;
    const float rise = dot(abs(receiver.gradient), abs(away) + cell);
    if (!(above > kLeastAbove + kSlopeError * rise)) return blockers;
    // The plane itself spreads over the cell, too.
    const float slope = (1.0 + kSquareError) * dot(receiver.gradient, receiver.gradient) * cell * cell / 12.0;
    const float own = slope + 2.0 * kDeviationError * spread.deviation;
    const float square = above * above + max(spread.deviation * spread.deviation - own, 0.0);
    blockers.gap = square / above - ground + DepthGap(plane, receiver.depth);
    blockers.share = blockers.gap > 0.0 ? above * above / square : 0.0;
    return blockers;
}

// The depth of the ground below the receiver's plane where no texel shows it: as far as a texel is wide.
float UsualGround(ConeScales scales)
{
    return scales.depthPerMetre / max(scales.texelsPerMetre, 1e-9);
}

// Takes a texel near the receiver into account: the nearest texel below the plane is the ground. found says whether
// there was one.
float GroundWithTexel(float ground, inout bool found, float depth, float2 away, QuadReceiver receiver,
                      ConeScales scales)
{
    const float below = DepthGap(PlaneDepth(receiver, away), depth);
    const bool isGround = below > 0.0 && below < (found ? ground : kDeepestGround * UsualGround(scales));
    found = found || isGround;
    return isGround ? below : ground;
}

// Sums over all cells: those in the light's cone, and those in a cone kNearbyCones as wide.
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

// area is what of the cell belongs to its ring.
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
