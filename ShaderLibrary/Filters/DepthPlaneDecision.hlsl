// Penumbra: what maps of depth planes say of the texels around a receiver.
//
// Computes:   whether no texel of a block of the shadow map blocks a receiver, or each does; the same of a disc.
// Source:     derived here, from Map/DepthPlanes.hlsl.
// Inputs:     QuadReceiver; depthPlanes: of 4 x 4 texels, with mip levels.
// Cost:       1 fetch for each of up to 3 x 3 blocks, until one is undecided or differs from those before it.
// Guarantees: a texel blocks where it is nearer to the light both than the receiver and than the receiver's plane at
//             the texel's centre, as TexelQuad.hlsl and SingleLoop.hlsl test it. What is decided is the answer of that
//             test for every texel of the block, in floats.
// Use it:     for early exits that change no bit of a filter's answer. Not: for tests with a cone, which texels nearer
//             than the receiver may fail.
#ifndef PENUMBRA_DEPTH_PLANE_DECISION_HLSL
#define PENUMBRA_DEPTH_PLANE_DECISION_HLSL

#include "../Map/DepthPlanes.hlsl"
#include "TexelQuad.hlsl"

// With 2, 3, 4 and 6 blocks, a single loop in a disc of 0.1 m takes 16.9, 16.1, 17.3 and 20.4 fetches per pixel, over
// three scenes.
static const int kBlocksAcross = 3;

struct BlockDecision
{
    bool noneBlocks;
    bool allBlock;
};

// away leads from the receiver to the block's centre, texels.
BlockDecision DecideBlock(DepthPlanes block, float2 away, float blockTexels, QuadReceiver receiver)
{
    const float2 level = float2(0.0, 0.0);
    const float plane = receiver.depth + dot(receiver.gradient, away);
    const float own = Parting(receiver.gradient, level, blockTexels);
    const float slope = Parting(block.gradient, level, blockTexels);
    // The margin is of the terms because the plane's depth may be small and its terms large.
    const float terms = abs(receiver.depth) + dot(abs(receiver.gradient), abs(away));
    const float margin = kPlanesRounding * (1.0 + abs(block.nearest) + abs(block.farthest) + terms + own + slope);
    const float parting = Parting(block.gradient, receiver.gradient, blockTexels) + margin;
    // A plane that leaves the map in front is compared at the map's end (KeepBehindNearPlane), so no part of the block
    // may leave it.
    const bool inMap = DepthGap(kNearestDepth, plane) > own + margin;
    const bool below = inMap && DepthGap(block.nearest, plane) + parting < 0.0;
    const bool behind = DepthGap(block.nearest, receiver.depth) + slope + margin < 0.0;
    const bool above = DepthGap(block.farthest, plane) - parting > 0.0;
    const bool before = DepthGap(block.farthest, receiver.depth) - slope - margin > 0.0;
    BlockDecision decision;
    decision.noneBlocks = below || behind;
    decision.allBlock = above && before;
    return decision;
}

// The decision for the texels that lie, in part or as a whole, within `radius` texels of the receiver.
BlockDecision DecideDisc(TEXTURE2D(depthPlanes), float radius, QuadReceiver receiver)
{
    const DiscBlocks blocks = BlocksOfDisc(receiver.centre, radius, kBlocksAcross, receiver.bounds);
    const float blockTexels = kRangeBlock * PowerOfTwo(blocks.level);
    BlockDecision disc;
    disc.noneBlocks = blocks.whole;
    disc.allBlock = blocks.whole;
    int2 texel = blocks.low;
    UNITY_LOOP
    while (HoldsBlock(texel, blocks) && (disc.noneBlocks || disc.allBlock))
    {
        const float2 away = (float2(texel) + 0.5) * blockTexels - receiver.centre;
        const float2 nearest = max(abs(away) - 0.5 * blockTexels, 0.0);
        if (dot(nearest, nearest) <= radius * radius)
        {
            const DepthPlanes planes = UnpackPlanes(LOAD_TEXTURE2D_LOD(depthPlanes, texel, blocks.level));
            const BlockDecision block = DecideBlock(planes, away, blockTexels, receiver);
            disc.noneBlocks = disc.noneBlocks && block.noneBlocks;
            disc.allBlock = disc.allBlock && block.allBlock;
        }
        texel = NextBlock(texel, blocks);
    }
    return disc;
}

#endif
