// Penumbra: what the soft shadows of Filament share.
//
// Computes:   Filament's taps and biases for a directional light, its radius of the light and its penumbra ratio.
// Source:     Filament (google/filament: surface_shadowing.fs as of commit 128523a, ShadowMapManager.cpp,
//             LightManager.h). The taps are the first of 64 points of S. Kosarevsky's poisson-disk-generator. In this
//             version, too, the first 16 lie in one half of the disk (y > 0, centroid 0.36, 0.50), and Filament takes
//             no more than 16: the disk, turned by a random angle per pixel, samples one side of the receiver. That is
//             most of its error: with 16 points on a Vogel disk, the RMSE in penumbrae of PCSS at 2 degrees falls from
//             0.28 to 0.14, the mean of 5 scenes.
// Inputs:     QuadReceiver, ConeScales; texels, metres, stored depth.
//             PENUMBRA_UNLIMITED: more taps than 16 are evenly spread.
// Cost:       no fetches but the search's.
// Guarantees: finite.
// Use it:     in FilamentPcss.hlsl and FilamentDpcf.hlsl. Not: as a disk of one's own.
//
// How Filament means its parameters:
// - The light is a bulb with a radius in metres (shadowBulbRadius, 0.02 by default) at the near plane. The search is as
//   wide as the bulb, the penumbra (d_receiver - d_blocker) / d_blocker times as wide, with distances from the near
//   plane. The sun's angular radius has no part in it. To compare it with a sun, the bulb is as wide as the sun's disc
//   at half the depth range (discShare 0.5): of 0.12 to 1 the share with the smallest error in the scene `trees` at 2
//   degrees. Receivers and blockers nearer to the near plane get wider penumbrae than the disc's, others narrower ones.
// - Bias: the receiver moves along its normal, half a texel times the sine of the angle to the light (normalBias 1).
//   Casters are drawn with a slope-scaled offset of two (polygonOffsetSlope 2), in place of Unity's 2.5; where a
//   pipeline cannot, slopeBias moves the receiver by as much of its own slope. The constant offset of half a step of
//   stored depth is omitted. Taps are tested against the receiver's plane.
//
// What is different here: the plane is from the normal, where Filament has it from screen derivatives, which are not
// finite where the surface is seen edge-on. The blocker's distance is at least 2^-24, where Filament divides by 0. Taps
// beside the tile are taken at its edge, where Filament has a border of a texel more. Disks are no wider than the tile.
#ifndef PENUMBRA_FILAMENT_TAPS_HLSL
#define PENUMBRA_FILAMENT_TAPS_HLSL

#include "../Taps/DepthTaps.hlsl"
#include "../Taps/ReceiverNormal.hlsl"
#include "../../Core/Disk.hlsl"
#include "Parameters/FilamentParameters.hlsl"

static const float kFilamentSmallestDistance = 5.9604645e-8; // 2^-24
static const int kFilamentTapCount = 16;
static const float2 kFilamentTaps[16] = {
    float2(0.511749, 0.547686), float2(0.58929, 0.257224), float2(0.165018, 0.57663), float2(0.407692, 0.742285),
    float2(0.707012, 0.646523), float2(0.31463, 0.466825), float2(0.801257, 0.485186), float2(0.418136, 0.146517),
    float2(0.579889, 0.0368284), float2(0.79801, 0.140114), float2(-0.0413185, 0.371455), float2(-0.0529108, 0.627352),
    float2(0.0821375, 0.882071), float2(0.17308, 0.301207), float2(-0.120452, 0.867216), float2(0.371096, 0.916454)};

int FilamentCount(int wanted)
{
#if defined(PENUMBRA_UNLIMITED)
    return BoundedSampleCount(wanted);
#else
    return min(max(wanted, 1), kFilamentTapCount);
#endif
}

float2 FilamentTap(int index, int count)
{
#if defined(PENUMBRA_UNLIMITED)
    return VogelDisk(index, count);
#else
    return kFilamentTaps[min(max(index, 0), kFilamentTapCount - 1)];
#endif
}

// The receiver with both biases.
QuadReceiver FilamentReceiver(ShadowReceiver receiver, ShadowTile tile, ConeScales scales,
                              FilamentParameters parameters)
{
    const QuadReceiver surface = PrepareQuads(receiver, tile);
    const float3 normal = ReceiverNormalLS(surface, scales);
    const float sine = sqrt(max(1.0 - normal.z * normal.z, 0.0));
    const float texel = 1.0 / max(scales.texelsPerMetre, 1e-6);
    const float away = 0.5 * BoundedOrLow(parameters.normalBias, 0.0, 64.0) * texel * sine;
    QuadReceiver moved = MoveReceiver(surface, normal * away, scales);
    const float slope =
        max(abs(moved.gradient.x), abs(moved.gradient.y)) * BoundedOrLow(parameters.slopeBias, 0.0, 64.0);
    moved.depth = min(max(MoveTowardLight(moved.depth, slope), 0.0), 1.0);
    return moved;
}

// The radius of Filament's bulb, texels.
float FilamentBulbRadius(ConeScales scales, FilamentParameters parameters)
{
    const float disc = BoundedOrLow(parameters.discShare, 0.0, 64.0) * scales.texelsPerDepth;
    const float bulb = BoundedOrLow(parameters.bulbRadiusMetres, 0.0, 1e6) * scales.texelsPerMetre;
    return min(disc + bulb, scales.largestRadius);
}

// blockerHeight is the blockers' mean height over the far plane, stored depth.
float FilamentPenumbraRatio(QuadReceiver receiver, float blockerHeight)
{
    const float gap = blockerHeight - DepthGap(receiver.depth, kFarthestDepth);
    return min(gap / max(1.0 - blockerHeight, kFilamentSmallestDistance), 1e9);
}

struct FilamentBlockers
{
    float count;
    float heightSum; // sum of heights over the far plane, stored depth
};

// A texel as near as the receiver's plane blocks, because the biases keep the receiver's own surface off it.
FilamentBlockers FilamentSearch(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, float2 rotation,
                                float radius, int count)
{
    FilamentBlockers blockers;
    blockers.count = 0.0;
    blockers.heightSum = 0.0;
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        const float2 offset = RotateDisk(FilamentTap(i, count), rotation) * radius;
        const float2 texels = ClampToTile(receiver.centre + offset, receiver.bounds);
        const float mapDepth = PointDepth(TEXTURE2D_ARGS(shadowMap, sampler_point), receiver, texels);
        const float height = DepthGap(mapDepth, kFarthestDepth);
        const float plane = dot(RisePerTexel(receiver), offset);
        if (DepthGap(mapDepth, receiver.depth) >= plane)
        {
            blockers.count += 1.0;
            blockers.heightSum += height;
        }
    }
    return blockers;
}

#endif
