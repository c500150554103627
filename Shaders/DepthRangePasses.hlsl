// Penumbra: the passes that make maps of depth ranges, and the quarter-resolution variance map.
//
// Computes:   QuarterDepthRange   nearest and farthest of every 4 x 4 texels of the shadow map, rounded outward
//             DilatedDepthRange   of all quarter-resolution texels within a radius that each cascade has
//             DepthRangeMip       of 2 x 2 texels of the level before
//             QuarterVariance     mean and mean square of every 4 x 4 texels, centred depths
// Source:     Map/DepthRange.hlsl, Map/DepthMoments.hlsl.
// Inputs:     _MainLightShadowmapTexture, _PenumbraMainLightAtlasTexelSize; _PenumbraSourceTexture: the
//             quarter-resolution ranges, or the level before; _PenumbraTile, _PenumbraCascade;
//             _PenumbraDepthRangeParameters0.
// Cost:       4 gathers, or 1 load for each texel of the disc inside of the tile (197 for radius 8), or 4 loads.
// Guarantees: nothing outside of the tile is read, where the tile's size is a multiple of 4 and, of a level, of the
//             level's texels; NaN texels are farthest.
// Use it:     as passes that run for each cascade. Not: levels whose texels do not divide the tile, which hold parts
//             of it alone.
#ifndef PENUMBRA_DEPTH_RANGE_PASSES_HLSL
#define PENUMBRA_DEPTH_RANGE_PASSES_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Filters/SingleLoop/Parameters/DepthRangeParameters.hlsl"
#include "../ShaderLibrary/Map/DepthMoments.hlsl"
#include "../ShaderLibrary/Map/DepthRange.hlsl"
#include "../ShaderLibrary/Pipelines/Urp.hlsl"

float4 _PenumbraTile;
int _PenumbraCascade;
float4 _PenumbraDepthRangeParameters0;

// A quarter of the block that a texel of the target stands for, gathered at the corner that its texels share.
float4 BlockDepths(int2 texel, int quarter)
{
    const float2 corner = kRangeBlock * float2(texel) + float2((quarter & 1) == 0 ? 1.0 : 3.0, quarter < 2 ? 1.0 : 3.0);
    return SanitizeMapDepth(GATHER_RED_TEXTURE2D(_MainLightShadowmapTexture, sampler_PenumbraPointClamp,
                                                 corner * _PenumbraMainLightAtlasTexelSize.xy));
}

float4 QuarterDepthRange(ScreenVaryings input) : SV_Target
{
    float2 range = kEmptyRange;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
        range = JoinRanges(range, RangeOfFour(BlockDepths(int2(input.positionCS.xy), i)));
    return float4(RoundRangeOutward(range), 0.0, 0.0);
}

int DilationOfCascade(DepthRangeParameters parameters)
{
    const int front = _PenumbraCascade == 0 ? parameters.dilation0 : parameters.dilation1;
    const int back = _PenumbraCascade == 2 ? parameters.dilation2 : parameters.dilation3;
    return min(max(_PenumbraCascade < 2 ? front : back, 0), kLargestDilation);
}

float4 DilatedDepthRange(ScreenVaryings input) : SV_Target
{
    const int radius = DilationOfCascade(UnpackDepthRangeParameters(_PenumbraDepthRangeParameters0));
    const int2 texel = int2(input.positionCS.xy);
    const int2 low = max(int2(_PenumbraTile.xy), texel - radius);
    const int2 high = min(int2(_PenumbraTile.xy + _PenumbraTile.zw) - 1, texel + radius);
    float2 range = kEmptyRange;
    for (int y = low.y; y <= high.y; ++y)
    {
        for (int x = low.x; x <= high.x; ++x)
        {
            UNITY_BRANCH
            if (InDilation(int2(x, y) - texel, radius))
                range = JoinRanges(range, LOAD_TEXTURE2D_X(_PenumbraSourceTexture, int2(x, y)).xy);
        }
    }
    return float4(range, 0.0, 0.0);
}

float4 DepthRangeMip(ScreenVaryings input) : SV_Target
{
    const int2 first = 2 * int2(input.positionCS.xy);
    float2 range = kEmptyRange;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
        range = JoinRanges(range, LOAD_TEXTURE2D_X(_PenumbraSourceTexture, first + int2(i & 1, i >> 1)).xy);
    return float4(range, 0.0, 0.0);
}

float4 QuarterVariance(ScreenVaryings input) : SV_Target
{
    float2 sum = float2(0.0, 0.0);
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const float4 stored = BlockDepths(int2(input.positionCS.xy), i);
        sum += (DepthMoments(stored.x) + DepthMoments(stored.y)) + (DepthMoments(stored.z) + DepthMoments(stored.w));
    }
    return float4(0.0625 * sum, 0.0, 0.0);
}

#endif
