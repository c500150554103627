// Penumbra: early exits of the single-loop soft shadow, from maps of depth ranges.
//
// Computes:   what SingleLoop.hlsl computes, without its loop where the nearest and the farthest depth around the
//             receiver show that no texel of the disc blocks, or that all do.
// Source:     as SingleLoop.hlsl; Map/DepthRange.hlsl.
// Inputs:     those of SingleLoop.hlsl. depthRanges: ranges of 4 x 4 texels, in FilterSingleLoopMinMax dilated by a
//             radius of each cascade, in FilterSingleLoopMips with mip levels.
// Cost:       MinMax: 1 fetch, 5 where the dilation is 0 and decides, else 33. Mips: 4, else 36 (32 where the disc has
//             no level).
// Guarantees: those of SingleLoop.hlsl. Mips: the same answer to the last bit. MinMax: the same answer wherever the
//             disc is no wider than the dilation reaches (DilationReach); where it is wider, a range that decides is
//             believed for the whole disc, which is how the source defines this exit: penumbrae end there.
// Use it:     Mips, where large areas are in full shadow or face the light. Not: to save work on lit slopes, whose
//             upper side lies nearer to the light than the receiver: a range cannot tell it from a blocker.
#ifndef PENUMBRA_SINGLE_LOOP_RANGES_HLSL
#define PENUMBRA_SINGLE_LOOP_RANGES_HLSL

#include "../../Map/DepthRange.hlsl"
#include "SingleLoop.hlsl"

// Floats lose this of a receiver's plane, as a share of the terms that it is the sum of.
static const float kPlaneRounding = 1e-6;
// Each of the four taps lies this far along both axes, and so 1 texel from the receiver.
static const float kFourTapTexels = 0.70710678;

// The visibility 1, 0 or kUndecided of all taps within `reach` texels, whose texels' depths lie in the range. A tap
// that blocks is nearer than the receiver itself, so a range that is not nearer decides alone; one that is may still
// lie below the plane.
float DecideByRange(float2 range, QuadReceiver receiver, float reach)
{
    if (!(DepthGap(range.x, receiver.depth) > 0.0)) return 1.0;
    const float rise = length(receiver.gradient) * (reach + kTapToCentreTexels);
    const float margin = kPlaneRounding * (1.0 + rise);
    return DepthGap(range.y, receiver.depth) > rise + margin ? 0.0 : kUndecided;
}

// The share of the four texels around the receiver that do not block.
float FourTapVisibility(TEXTURE2D(shadowMap), QuadReceiver receiver)
{
    float lit = 0.0;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const float2 offset = float2((i & 1) == 0 ? -kFourTapTexels : kFourTapTexels,
                                     i < 2 ? -kFourTapTexels : kFourTapTexels);
        lit += BlockingGap(shadowMap, receiver, receiver.centre + offset) > 0.0 ? 0.0 : 1.0;
    }
    return 0.25 * lit;
}

// This is the last of the source's exits, for a caller that knows the surface's normal: a surface that faces away from
// the light and whose four taps are dark is not worth a loop, whose result would be multiplied by no light. The
// techniques leave it out, because a screen's passes do not know the surface's shading normal.
bool IsDarkFacingAway(float normalDotLight, float fourTapVisibility)
{
    return normalDotLight <= 0.0 && fourTapVisibility < 0.0001;
}

// Tiles lie row by row in the atlas, as URP places its cascades.
int TileIndex(ShadowTile tile)
{
    const float2 extent = max(FiniteOr(tile.offsetScale.zw, float2(1.0, 1.0)), 1e-3);
    const float2 place = floor(FiniteOr(tile.offsetScale.xy, float2(0.0, 0.0)) / extent + 0.5);
    const float index = place.x + place.y * floor(1.0 / extent.x + 0.5);
    return int(min(max(index, 0.0), 3.0));
}

int DilationOfTile(int index, SingleLoopParameters parameters)
{
    const int front = index == 0 ? parameters.dilation0 : parameters.dilation1;
    const int back = index == 2 ? parameters.dilation2 : parameters.dilation3;
    return min(max(index < 2 ? front : back, 0), kLargestDilation);
}

float FilterSingleLoopMinMax(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                             TEXTURE2D(depthRanges), ShadowReceiver receiver, ShadowTile tile,
                             SingleLoopParameters parameters)
{
    const SingleLoop loop = PrepareSingleLoop(receiver, tile, parameters);
    const float reach = DilationReach(DilationOfTile(TileIndex(tile), parameters));
    const int2 texel = BlockAt(loop.receiver.centre, 0, loop.receiver.bounds);
    const float2 range = LOAD_TEXTURE2D_LOD(depthRanges, texel, 0).xy;
    const float decided = DecideByRange(range, loop.receiver, min(loop.radius, reach));
    // A range that reaches farther than the four taps holds their depths, too, so it decides for them.
    if (decided >= 0.0 && reach > 1.0) return decided;
    if (decided >= 0.0) return FourTapVisibility(shadowMap, loop.receiver);
    return RunSingleLoop(shadowMap, loop);
}

float FilterSingleLoopMips(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                           TEXTURE2D(depthRanges), ShadowReceiver receiver, ShadowTile tile,
                           SingleLoopParameters parameters)
{
    const SingleLoop loop = PrepareSingleLoop(receiver, tile, parameters);
    const float reach = loop.radius + kTapToCentreTexels;
    const DiscBlocks blocks = BlocksOfDisc(loop.receiver.centre, reach, 2, loop.receiver.bounds);
    float visibility = -1.0;
    if (blocks.whole)
    {
        float2 range = kEmptyRange;
        UNITY_UNROLL
        for (int i = 0; i < 4; ++i)
        {
            const int2 texel = int2((i & 1) == 0 ? blocks.low.x : blocks.high.x, i < 2 ? blocks.low.y : blocks.high.y);
            range = JoinRanges(range, LOAD_TEXTURE2D_LOD(depthRanges, texel, blocks.level).xy);
        }
        visibility = DecideByRange(range, loop.receiver, loop.radius);
    }
    if (!(visibility >= 0.0)) visibility = RunSingleLoop(shadowMap, loop);
    return visibility;
}

#endif
