// Penumbra: exponential variance soft shadows on mip levels.
//
// Computes:   visibility of a disc light: the blocker's depth from the mean of exp(-c z) over the area that the
//             farthest blocker's penumbra could cover, a soft minimum, then the smaller of two bounds of Chebyshev's
//             over the area that this blocker's penumbra covers.
// Source:     Google's Filament, 2026 (its "EVSSM", pull request 10188): one fetch at level log2(search radius); five
//             at level log2(penumbra radius) - 1, the middle with weight 1/2, four at half that radius each way with
//             1/8; exponent 5.54 of depths in [-1, 1] with 16 bits and 42 with 32; smallest variance 0.002 of the mean
//             square; light bleeding below 0.15 removed. Here widths are those of Core/Penumbra.hlsl, and levels are
//             means of 2 x 2, which there are a Gaussian's of 3 x 3.
// Inputs:     moments: of Map/DepthWarp.hlsl, with mip levels; linear sampler; ShadowReceiver; ShadowTile.
//             ExponentialVarianceParameters: exponents are of depths in [-1/2, 1/2], twice those above.
// Cost:       6 filtered fetches of four channels.
// Guarantees: [0, 1] for any input; nothing outside of the tile counts.
// Use it:     to compare with. Not: where a blocker stands beside one that is much nearer to the light: the soft
//             minimum takes the nearer one's depth for both, however small its share.
#ifndef PENUMBRA_EXPONENTIAL_LEVELS_HLSL
#define PENUMBRA_EXPONENTIAL_LEVELS_HLSL

#include "../../Platform/Platform.hlsl"
#include "Parameters/ExponentialVarianceParameters.hlsl"
#include "../../Core/MomentBounds.hlsl"
#include "../../Core/Penumbra.hlsl"
#include "../../Map/DepthWarp.hlsl"
#include "../../Map/MapLevels.hlsl"

float4 LevelTexel(TEXTURE2D(moments), SAMPLER(sampler_moments), float2 texels, float level, ShadowTile tile)
{
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    const float2 inside = ClampToLevel(texels, level, BoundsInTexels(tile));
    return SAMPLE_TEXTURE2D_LOD(moments, sampler_moments, inside / size, level);
}

// The gap of the depth at which a lone blocker would leave this mean of exp(-c z).
float SoftMinimumGap(float meanExponential, float exponent, float depth)
{
    const float blocker = -log(max(meanExponential, 1e-37)) / exponent;
    return max(depth - max(blocker, -0.5), 0.0);
}

float4 FiveTaps(TEXTURE2D(moments), SAMPLER(sampler_moments), float2 texels, float radius, ShadowTile tile)
{
    const float ideal = log2(max(radius, 1.0)) - 1.0;
    const float level = min(max(ideal, 0.0), CoarsestLevel(BoundsInTexels(tile)));
    const float apart = 0.5 * radius * exp2(max(ideal - level, 0.0));
    float4 mean = 0.5 * LevelTexel(TEXTURE2D_ARGS(moments, sampler_moments), texels, level, tile);
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const float2 side = float2((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0);
        mean += 0.125 * LevelTexel(TEXTURE2D_ARGS(moments, sampler_moments), texels + apart * side, level, tile);
    }
    return mean;
}

float FilterExponentialLevels(TEXTURE2D(moments), SAMPLER(sampler_moments), ShadowReceiver receiver, ShadowTile tile,
                              ExponentialVarianceParameters parameters)
{
    const float2 texels = TexelCoordinates(receiver.shadowCoord.xy, tile);
    const ConeScales scales = ConeScalesOf(tile);
    const float2 exponents = float2(BoundedOrLow(parameters.positiveExponent, 1.0, kLargestSquaredExponent),
                                    BoundedOrLow(parameters.negativeExponent, 1.0, kLargestSquaredExponent));
    const float receiverDepth = SanitizeReceiverDepth(receiver.shadowCoord.z);
    const float depth = CentredDepth(receiverDepth);

    const float search = PenumbraRadius(LargestGap(receiverDepth), scales);
    const float level = min(log2(max(search, 1.0)), CoarsestLevel(BoundsInTexels(tile)));
    const float nearby = -LevelTexel(TEXTURE2D_ARGS(moments, sampler_moments), texels, level, tile).y;
    const float radius = PenumbraRadius(SoftMinimumGap(nearby, exponents.y, depth), scales);

    const float4 filtered = FiveTaps(TEXTURE2D_ARGS(moments, sampler_moments), texels, radius, tile);
    const float2 warped = WarpedDepth(depth, exponents);
    const float precision = BoundedOrLow(parameters.precision, 5.9604645e-8, 1e-2);
    const float2 smallest = kRoundings * precision * warped * warped;
    const float bound = min(ChebyshevBound(filtered.xz, warped.x, smallest.x),
                            ChebyshevBound(filtered.yw, warped.y, smallest.y));
    return SanitizeVisibility(ReduceBleeding(bound, BoundedOrLow(parameters.bleeding, 0.0, 0.95)));
}

#endif
