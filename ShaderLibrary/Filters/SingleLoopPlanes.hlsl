// Penumbra: early exits of the single-loop soft shadow, from a map of depth planes.
//
// Computes:   what SingleLoop.hlsl computes, without its loop where the planes of the blocks around the receiver show that
//             no texel of the disc blocks, or that all do.
// Source:     SingleLoopExits.hlsl, with Map/DepthPlanes.hlsl in place of ranges: a receiver on a lit slope is decided
//             too, since the slope's own texels lie in a thin layer below the receiver's plane.
// Inputs:     those of SingleLoop.hlsl; depthPlanes: of 4 x 4 texels, with mip levels.
// Cost:       4 fetches where the planes decide, else 36 (32 where the disc is wider than half of the tile).
// Guarantees: those of SingleLoop.hlsl, and the same answer to the last bit: no pixel of a penumbra is taken for lit or
//             dark.
// Use it:     in place of SingleLoop.hlsl and of a penumbra mask, where the map's passes cost less than they save.
#ifndef PENUMBRA_SINGLE_LOOP_PLANES_HLSL
#define PENUMBRA_SINGLE_LOOP_PLANES_HLSL

#include "../Map/DepthPlanes.hlsl"
#include "SingleLoopExits.hlsl"

// 1 where no texel of the block blocks, 0 where each does, or kUndecided. away: from the receiver to the block's centre.
float DecideByPlanes(DepthPlanes block, float2 away, float blockTexels, QuadReceiver receiver)
{
    const float2 level = float2(0.0, 0.0);
    const float plane = receiver.depth + dot(receiver.gradient, away);
    const float own = Parting(receiver.gradient, level, blockTexels);
    const float slope = Parting(block.gradient, level, blockTexels);
    const float margin = kPlanesRounding * (1.0 + abs(block.nearest) + abs(block.farthest) + abs(plane) + own + slope);
    const float parting = Parting(block.gradient, receiver.gradient, blockTexels) + margin;
    // A plane that leaves the map in front is compared at the map's end (KeepBehindNearPlane): no part of the block may.
    const bool inMap = DepthGap(kNearestDepth, plane) > own + margin;
    const bool below = inMap && DepthGap(block.nearest, plane) + parting < 0.0;
    const bool behind = DepthGap(block.nearest, receiver.depth) + slope + margin < 0.0;
    if (below || behind) return 1.0;
    const bool above = DepthGap(block.farthest, plane) - parting > 0.0;
    const bool before = DepthGap(block.farthest, receiver.depth) - slope - margin > 0.0;
    return above && before ? 0.0 : kUndecided;
}

float DecideBlock(TEXTURE2D(depthPlanes), int2 texel, int level, QuadReceiver receiver)
{
    const float blockTexels = kRangeBlock * exp2(float(level));
    const DepthPlanes block = UnpackPlanes(LOAD_TEXTURE2D_LOD(depthPlanes, texel, level));
    return DecideByPlanes(block, (float2(texel) + 0.5) * blockTexels - receiver.centre, blockTexels, receiver);
}

float FilterSingleLoopPlanes(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                             TEXTURE2D(depthPlanes), ShadowReceiver receiver, ShadowTile tile,
                             SingleLoopParameters parameters)
{
    const SingleLoop loop = PrepareSingleLoop(receiver, tile, parameters);
    const float reach = loop.radius + kTapToCentreTexels;
    const int level = LevelOfDisc(reach);
    if (level <= HighestWholeLevel(loop.receiver.bounds))
    {
        const int2 low = RangeTexel(loop.receiver.centre - reach, level, loop.receiver.bounds);
        const int2 high = RangeTexel(loop.receiver.centre + reach, level, loop.receiver.bounds);
        const float4 decided = float4(DecideBlock(depthPlanes, low, level, loop.receiver),
                                      DecideBlock(depthPlanes, int2(high.x, low.y), level, loop.receiver),
                                      DecideBlock(depthPlanes, int2(low.x, high.y), level, loop.receiver),
                                      DecideBlock(depthPlanes, high, level, loop.receiver));
        if (all(decided == 1.0)) return 1.0;
        if (all(decided == 0.0)) return 0.0;
    }
    return RunSingleLoop(shadowMap, loop);
}

#endif
