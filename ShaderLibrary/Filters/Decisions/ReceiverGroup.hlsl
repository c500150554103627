// Penumbra: what a block of the shadow map may do to a whole group of receivers.
//
// Computes:   bounds of receivers of one cascade: how far they lie from one of them, their depths, and how far their
//             planes part from its plane; with them, whether texels of a block of the map can block any receiver of the
//             group, and whether each must block all.
// Source:     derived here, from Map/DepthPlanes.hlsl.
// Inputs:     QuadReceiver of each receiver, all of one tile; planes of a block. Lengths in texels of the shadow map,
//             depths as stored.
// Cost:       no fetches.
// Guarantees: for every receiver of the group and every texel of the block, with the test of TexelQuad.hlsl: where
//             `noneAbove`, no texel is both nearer to the light than the receiver and above its plane; where
//             `allAbove`, each is above the plane; every texel is nearer to the light than the receiver by smallestGap
//             to largestGap. Floats are allowed for by a margin.
// Use it:     to decide a tile of pixels at once. Not: for receivers of spot lights.
#ifndef PENUMBRA_RECEIVER_GROUP_HLSL
#define PENUMBRA_RECEIVER_GROUP_HLSL

#include "../../Map/DepthPlanes.hlsl"
#include "../Taps/TexelQuad.hlsl"

struct ReceiverGroup
{
    QuadReceiver first; // the planes of the others are measured from its plane
    float spread;       // distance of the farthest receiver from the first
    float2 depths;      // x: nearest to the light, y: farthest
    float planeError;   // error of the first plane at the other receivers
    float tilt;         // tilt of the other planes against the first, depth per texel, sum of both axes
};

ReceiverGroup GroupOf(QuadReceiver receiver)
{
    ReceiverGroup group;
    group.first = receiver;
    group.spread = 0.0;
    group.depths = float2(receiver.depth, receiver.depth);
    group.planeError = 0.0;
    group.tilt = 0.0;
    return group;
}

// The size of the terms of a plane's depth, `away` from its receiver: rounding is a share of that.
float PlaneTerms(QuadReceiver receiver, float2 away)
{
    return abs(receiver.depth) + dot(abs(receiver.gradient), abs(away));
}

ReceiverGroup JoinGroup(ReceiverGroup group, QuadReceiver receiver)
{
    const float2 away = receiver.centre - group.first.centre;
    const float2 tilt = abs(receiver.gradient - group.first.gradient);
    const float plane = group.first.depth + dot(group.first.gradient, away);
    ReceiverGroup joined = group;
    joined.spread = max(group.spread, length(away));
    joined.depths = JoinRanges(group.depths, float2(receiver.depth, receiver.depth));
    const float rounding = kPlanesRounding * (abs(receiver.depth) + PlaneTerms(group.first, away));
    joined.planeError = max(group.planeError, abs(receiver.depth - plane) + rounding);
    joined.tilt = max(group.tilt, tilt.x + tilt.y);
    return joined;
}

struct GroupBounds
{
    bool noneAbove;
    bool noneAbovePlane; // whether or not the texels are nearer to the light than the receivers
    bool allAbove;
    float smallestGap;
    float largestGap;
    float nearest; // smallest distance from any receiver of the group to the block
};

// away leads from the group's first receiver to the block's centre. reach is the distance from a receiver to the texels
// that it reads.
GroupBounds BoundBlock(DepthPlanes block, float2 away, float blockTexels, float reach, ReceiverGroup group)
{
    const float2 level = float2(0.0, 0.0);
    const float plane = group.first.depth + dot(group.first.gradient, away);
    const float own = Parting(group.first.gradient, level, blockTexels);
    const float slope = Parting(block.gradient, level, blockTexels);
    const float others = group.planeError + group.tilt * reach;
    const float terms = abs(block.nearest) + abs(block.farthest) + PlaneTerms(group.first, away) + own + slope + others;
    const float margin = kPlanesRounding * (1.0 + terms);
    const float parting = Parting(block.gradient, group.first.gradient, blockTexels) + others + margin;
    // A plane that leaves the map in front is compared at the map's end (KeepBehindNearPlane), so no part of the block
    // may leave it.
    const bool inMap = DepthGap(kNearestDepth, plane) > own + others + margin;
    const float2 outside = max(abs(away) - 0.5 * blockTexels, 0.0);
    GroupBounds bounds;
    bounds.largestGap = DepthGap(block.nearest, group.depths.y) + slope + margin;
    bounds.smallestGap = DepthGap(block.farthest, group.depths.x) - slope - margin;
    bounds.noneAbovePlane = inMap && DepthGap(block.nearest, plane) + parting < 0.0;
    bounds.noneAbove = bounds.largestGap < 0.0 || bounds.noneAbovePlane;
    bounds.allAbove = DepthGap(block.farthest, plane) - parting > 0.0;
    bounds.nearest = max(length(outside) - group.spread, 0.0);
    return bounds;
}

#endif
