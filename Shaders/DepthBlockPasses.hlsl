// Penumbra: the passes that make the maps of depth planes and of depth spreads, both in one draw.
//
// Computes:   QuarterDepthBlocks  planes and spreads of every 4 x 4 texels of the shadow map
//             EighthDepthBlocks   of 2 x 2 of these blocks, in maps of their own
//             DepthBlocksMip      of 2 x 2 blocks of the level before, in these maps
// Source:     Map/DepthBlocks.hlsl. The kernels FirstLevels and NextLevel of PenumbraCellPcss.compute make the same
//             numbers.
// Inputs:     those of DepthRangePasses.hlsl; _PenumbraMip; _PenumbraSourcePlanes and _PenumbraSourceSpreads: the
//             blocks of the level before.
// Cost:       4 gathers; 8 loads.
// Guarantees: those of DepthRangePasses.hlsl.
// Use it:     as passes that run for each cascade, into four floats and four integers of 32 bits.
#ifndef PENUMBRA_DEPTH_BLOCK_PASSES_HLSL
#define PENUMBRA_DEPTH_BLOCK_PASSES_HLSL

#include "DepthRangePasses.hlsl"
#include "../ShaderLibrary/Map/DepthBlocks.hlsl"

int _PenumbraMip;
TEXTURE2D(_PenumbraSourcePlanes);
Texture2D<uint4> _PenumbraSourceSpreads;

struct BlockTargets
{
    float4 planes : SV_Target0;
    uint4 spreads : SV_Target1;
};

BlockTargets TargetsOf(DepthBlock block)
{
    BlockTargets targets;
    targets.planes = block.planes;
    targets.spreads = block.spreads;
    return targets;
}

BlockTargets QuarterDepthBlocks(ScreenVaryings input)
{
    float4 depths[4];
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i) depths[i] = BlockDepths(int2(input.positionCS.xy), i);
    return TargetsOf(BlockOfTexels(depths));
}

// blockTexels is the width of the blocks that are read.
BlockTargets JoinedBlocks(int2 pixel, float blockTexels)
{
    DepthBlock parts[4];
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const int2 part = 2 * pixel + int2(i & 1, i >> 1);
        parts[i].planes = LOAD_TEXTURE2D(_PenumbraSourcePlanes, part);
        parts[i].spreads = LOAD_TEXTURE2D(_PenumbraSourceSpreads, part);
    }
    return TargetsOf(JoinBlocks(parts, blockTexels));
}

BlockTargets EighthDepthBlocks(ScreenVaryings input)
{
    return JoinedBlocks(int2(input.positionCS.xy), kRangeBlock);
}

BlockTargets DepthBlocksMip(ScreenVaryings input)
{
    return JoinedBlocks(int2(input.positionCS.xy), kRangeBlock * PowerOfTwo(_PenumbraMip));
}

#endif
