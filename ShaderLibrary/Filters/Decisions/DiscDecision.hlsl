// Penumbra: what maps of depth planes say of the texels around a receiver.
//
// Computes:   whether no texel of a disc of the shadow map blocks a receiver, or each does.
// Source:     the bounds of ReceiverGroup.hlsl, of a single receiver.
// Inputs:     QuadReceiver; depthPlanes: of 4 x 4 texels, with mip levels.
// Cost:       1 fetch for each of up to 3 x 3 blocks, until one is undecided or differs from those before it.
// Guarantees: a texel blocks where it is nearer to the light both than the receiver and than the receiver's plane at
//             the texel's centre, as TexelQuad.hlsl and SingleLoop.hlsl test it. What is decided is the answer of that
//             test for every texel of the block, in floats.
// Use it:     for early exits that change no bit of a filter's answer. Not: for tests with a cone, which texels nearer
//             than the receiver may fail.
#ifndef PENUMBRA_DISC_DECISION_HLSL
#define PENUMBRA_DISC_DECISION_HLSL

#include "ReceiverGroup.hlsl"

// With 2, 3, 4 and 6 blocks, a single loop in a disc of 0.1 m takes 16.9, 16.1, 17.3 and 20.4 fetches per pixel, over
// three scenes.
static const int kBlocksAcross = 3;

struct DiscDecision
{
    bool noneBlocks;
    bool allBlock;
};

// The decision for the texels that lie, in part or as a whole, within `radius` texels of the receiver.
DiscDecision DecideDisc(TEXTURE2D(depthPlanes), float radius, QuadReceiver receiver)
{
    const DiscBlocks blocks = BlocksOfDisc(receiver.centre, radius, kBlocksAcross, receiver.bounds);
    const float blockTexels = kRangeBlock * PowerOfTwo(blocks.level);
    DiscDecision disc;
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
            const GroupBounds block = BoundBlock(planes, away, blockTexels, 0.0, GroupOf(receiver));
            disc.noneBlocks = disc.noneBlocks && block.noneAbove;
            disc.allBlock = disc.allBlock && block.allAbove && block.smallestGap > 0.0;
        }
        texel = NextBlock(texel, blocks);
    }
    return disc;
}

#endif
