// Penumbra: what a block of the shadow map holds: planes around its depths, and the spreads of its four cells.
//
// Computes:   DepthBlock of 4 x 4 texels, and of four blocks; a cell is a quarter of a block.
// Source:     DepthPlanes.hlsl, DepthSpread.hlsl.
// Inputs:     stored depths in [0, 1], either direction, sanitised.
// Cost:       no fetches.
// Guarantees: those of DepthPlanes.hlsl and DepthSpread.hlsl. Passes and kernels that make levels of these numbers call
//             the same functions with the same numbers, and differ at most in denormals, which devices may flush.
// Use it:     for both maps at once. Not: for one of them.
#ifndef PENUMBRA_DEPTH_BLOCKS_HLSL
#define PENUMBRA_DEPTH_BLOCKS_HLSL

#include "DepthPlanes.hlsl"
#include "DepthSpread.hlsl"

struct DepthBlock
{
    float4 planes; // PackPlanes
    uint4 spreads; // PackSpread of the block's cells, row by row
};

// depths holds those of the four quarters of 4 x 4 texels.
DepthBlock BlockOfTexels(float4 depths[4])
{
    DepthBlock block;
    block.spreads = uint4(0, 0, 0, 0);
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i) block.spreads[i] = PackSpread(SpreadOfFour(depths[i]));
    block.planes = PackPlanes(PlanesOfBlock(depths));
    return block;
}

// parts holds the four blocks, blockTexels wide, of a block twice as wide, row by row.
DepthBlock JoinBlocks(DepthBlock parts[4], float blockTexels)
{
    DepthPlanes planes[4];
    DepthBlock whole;
    whole.spreads = uint4(0, 0, 0, 0);
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        whole.spreads[i] = JoinPackedSpreads(parts[i].spreads);
        planes[i] = UnpackPlanes(parts[i].planes);
    }
    whole.planes = PackPlanes(JoinPlanes(planes, blockTexels));
    return whole;
}

#endif
