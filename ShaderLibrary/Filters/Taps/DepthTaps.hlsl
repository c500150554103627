// Penumbra: single taps of raw depth, inside their tile.
//
// Computes:   the depth of one texel, a depth interpolated between four, and the bilinear comparison of four with one
//             reference depth, as a comparison sampler makes it.
// Source:     percentage-closer filtering, Reeves, Salesin and Cook (1987), for the comparison.
// Inputs:     shadow map (raw reads), point sampler; QuadReceiver; texel coordinates.
// Cost:       1 fetch each.
// Guarantees: reads no texel outside the tile; NaN texels do not block and do not spread to their neighbours; results
//             are finite. Weights are exact, those of samplers have 8 bits.
// Use it:     in filters that follow another engine's rules. Not: with wide kernels of one's own: TexelQuad.hlsl tests
//             each texel against the receiver's plane.
#ifndef PENUMBRA_DEPTH_TAPS_HLSL
#define PENUMBRA_DEPTH_TAPS_HLSL

#include "TexelQuad.hlsl"

bool InTile(float2 texels, TileBounds bounds)
{
    return all(texels >= bounds.minimum + 0.5) && all(texels <= bounds.maximum - 0.5);
}

float2 ClampToTile(float2 texels, TileBounds bounds)
{
    return min(max(texels, bounds.minimum + 0.5), bounds.maximum - 0.5);
}

// Stored depth of the texel nearest to `texels`, which lies in the tile.
float PointDepth(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, float2 texels)
{
    const float2 coordinate = (floor(texels) + 0.5) * receiver.texelSize;
    return SanitizeMapDepth(SAMPLE_TEXTURE2D_LOD(shadowMap, sampler_point, coordinate, 0).x);
}

// Stored depth interpolated between the four texels nearest to `texels`.
float FilteredDepth(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, float2 texels)
{
    const float2 corner = ClampQuadCorner(texels, receiver.bounds);
    const float4 mapDepth = SanitizeMapDepth(GATHER_RED_TEXTURE2D(shadowMap, sampler_point,
                                                                  corner * receiver.texelSize));
    return dot(mapDepth, BilinearWeights(texels, corner));
}

// Bilinear comparison against one reference depth, as a comparison sampler does it.
float LitByGather(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, float2 texels, float reference)
{
    const float2 corner = ClampQuadCorner(texels, receiver.bounds);
    const float4 mapDepth = SanitizeMapDepth(GATHER_RED_TEXTURE2D(shadowMap, sampler_point,
                                                                  corner * receiver.texelSize));
    const float4 gap = DepthGap(mapDepth, float4(reference, reference, reference, reference));
    const float4 weight = BilinearWeights(texels, corner);
    const float blocked = dot(weight, float4(gap.x > 0.0, gap.y > 0.0, gap.z > 0.0, gap.w > 0.0));
    const float lit = dot(weight, float4(gap.x <= 0.0, gap.y <= 0.0, gap.z <= 0.0, gap.w <= 0.0));
    return LitShare(lit, blocked);
}

#endif
