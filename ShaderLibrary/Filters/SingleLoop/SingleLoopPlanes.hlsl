// Penumbra: early exits of the single-loop soft shadow, from a map of depth planes.
//
// Computes:   what SingleLoop.hlsl computes, without its loop where the planes of the blocks around the receiver show
//             that no texel of the disc blocks, or that all do.
// Source:     SingleLoopRanges.hlsl, with Map/DepthPlanes.hlsl in place of ranges: a receiver on a lit slope is decided
//             too, since the slope's own texels lie in a thin layer below the receiver's plane.
// Inputs:     those of SingleLoop.hlsl; depthPlanes: of 4 x 4 texels, with mip levels.
// Cost:       1 to 9 fetches where the planes decide, else as many and 32 (32 where no level has blocks wide enough).
// Guarantees: those of SingleLoop.hlsl, and the same answer to the last bit: no pixel of a penumbra is taken for lit or
//             dark.
// Use it:     in place of SingleLoop.hlsl and of a penumbra mask, where the map's passes cost less than they save.
#ifndef PENUMBRA_SINGLE_LOOP_PLANES_HLSL
#define PENUMBRA_SINGLE_LOOP_PLANES_HLSL

#include "../Decisions/DiscDecision.hlsl"
#include "SingleLoop.hlsl"

float FilterSingleLoopPlanes(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                             TEXTURE2D(depthPlanes), ShadowReceiver receiver, ShadowTile tile,
                             SingleLoopParameters parameters)
{
    const SingleLoop loop = PrepareSingleLoop(receiver, tile, parameters);
    const DiscDecision disc = DecideDisc(depthPlanes, loop.radius + kTapToCentreTexels, loop.receiver);
    if (disc.noneBlocks) return 1.0;
    if (disc.allBlock) return 0.0;
    return RunSingleLoop(shadowMap, loop);
}

#endif
