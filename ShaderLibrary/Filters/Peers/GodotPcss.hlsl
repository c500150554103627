// Penumbra: PCSS by the rules of Godot 4, for comparison.
//
// Computes:   what Godot's directional light computes while its angular size is not 0: the mean depth of blockers on a
//             disk as wide as the light's cone at the near plane, then the lit share of that disk scaled by
//             (d_receiver - d_blocker) / d_blocker, with distances from the near plane.
// Source:     Godot 4 (godotengine/godot: scene_forward_lights_inc.glsl as of commit 001d4b2, light_storage.cpp,
//             renderer_scene_cull.cpp, renderer_scene_render_rd.cpp): as many taps for the search as for the filter, on
//             the same Vogel disk, whose angle is 2.4 radians and not the golden one. Of its qualities of the soft
//             shadow filter, Hard and Very Low have 4 taps, Low 8, Medium 12, High 24, Ultra 32. The default is Low.
// Inputs:     shadow map (raw reads; the comparison sampler is not used), point sampler; ShadowReceiver; ShadowTile;
//             GodotPcssParameters.
// Cost:       samples fetches where nothing blocks, else twice as many.
// Guarantees: [0, 1] for any input; exactly 1 without blockers, exactly 0 below a wall; texels outside the tile are not
//             read.
// Use it:     for comparison with Godot; the renderer feature does not offer it. Not: when the light's angular diameter
//             must be exact: PcssAngular.hlsl.
//
// How Godot means its parameters:
// - The light's angular size is its diameter in degrees (0.5 for the sun). Its tangent is the penumbra's radius per
//   distance: twice the radius of that disc. With diameterShare 0.5 the light is given half its diameter instead.
// - The division by the blocker's distance belongs to a light at the near plane. It makes the penumbra wider than the
//   disc's by d_receiver / d_blocker.
// - Blockers are searched in depths that are interpolated between texels: at an edge of a caster they lie between
// caster
//   and ground, where nothing is.
// - Bias: the receiver moves 0.001 of the depth range toward the light (shadow_bias 0.1), and across the light by its
//   normal's part there times two texels (shadow_normal_bias 2). The receiver's plane is not used, so wide disks shadow
//   the slope that they lie on. Casters are drawn without Godot's biases, but with Unity's slope-scaled one, without
//   which more lit surfaces shadow themselves.
//
// With an angular diameter of 0 this is one bilinear comparison per tap; Godot then has another filter.
//
// What is different here: taps beside the tile are taken at its edge, where Godot reads the neighbouring cascade. The
// blocker's distance is at least kGodotSmallestDistance, where Godot divides by 0. Disks are no wider than the tile.
// Godot rotates the disk the other way round.
#ifndef PENUMBRA_GODOT_PCSS_HLSL
#define PENUMBRA_GODOT_PCSS_HLSL

#include "../Taps/DepthTaps.hlsl"
#include "../Taps/ReceiverNormal.hlsl"
#include "../../Core/Disk.hlsl"
#include "Parameters/GodotPcssParameters.hlsl"

static const float kGodotSmallestDistance = 5.9604645e-8; // 2^-24
static const float kGodotAngle = 2.4;                 // radians between taps

float2 GodotDisk(int index, int count)
{
    const float angle = kGodotAngle * float(index);
    return float2(cos(angle), sin(angle)) * sqrt((float(index) + 0.5) / float(count));
}

// The radius of the light's cone per distance, as a multiple of the exact tan(a/2).
float GodotWidening(float tanHalf, float diameterShare)
{
    const float angle = min(2.0 * atan(tanHalf) * diameterShare, 1.5);
    return tanHalf > 1e-6 ? tan(angle) / tanHalf : 2.0 * diameterShare;
}

// The receiver with both biases.
QuadReceiver GodotReceiver(ShadowReceiver receiver, ShadowTile tile, ConeScales scales, GodotPcssParameters parameters)
{
    const QuadReceiver surface = PrepareQuads(receiver, tile);
    const float texel = 1.0 / max(scales.texelsPerMetre, 1e-6);
    const float2 across =
        ReceiverNormalLS(surface, scales).xy * (BoundedOrLow(parameters.normalBias, 0.0, 64.0) * texel);
    QuadReceiver prepared = MoveReceiver(surface, float3(across, 0.0), scales);
    prepared.depth = min(max(MoveTowardLight(prepared.depth, BoundedOrLow(parameters.depthBias, 0.0, 1.0)), 0.0), 1.0);
    prepared.depth = KeepBehindNearPlane(prepared.depth);
    return prepared;
}

// The radius of the light's cone at the near plane, texels.
float GodotSearchRadius(QuadReceiver prepared, ConeScales scales, GodotPcssParameters parameters)
{
    const float tanHalf =
        scales.texelsPerMetre > 0.0 ? scales.texelsPerDepth * scales.depthPerMetre / scales.texelsPerMetre : 0.0;
    const float widening = GodotWidening(tanHalf, BoundedOrLow(parameters.diameterShare, 0.0, 4.0));
    return min(widening * scales.texelsPerDepth * LargestGap(prepared.depth), scales.largestRadius);
}

float FilterGodotPcss(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                      ShadowReceiver receiver, ShadowTile tile, GodotPcssParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const QuadReceiver prepared = GodotReceiver(receiver, tile, scales, parameters);
    const float2 rotation = UnitRotation(receiver.rotation);
    const int count = BoundedSampleCount(parameters.samples);
    const float receiverDistance = LargestGap(prepared.depth); // distance from the near plane
    const float searchRadius = GodotSearchRadius(prepared, scales, parameters);
    float distanceSum = 0.0;
    float blockers = 0.0;
    int i;
    UNITY_LOOP
    for (i = 0; i < count; ++i)
    {
        const float2 offset = RotateDisk(GodotDisk(i, count), rotation) * searchRadius;
        const float mapDepth = FilteredDepth(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared,
                                             prepared.centre + offset);
        if (IsBlocker(mapDepth, prepared.depth))
        {
            distanceSum += LargestGap(mapDepth);
            blockers += 1.0;
        }
    }
    if (!(blockers > 0.0)) return 1.0;

    const float blockerDistance = max(distanceSum / blockers, kGodotSmallestDistance);
    const float ratio = max(receiverDistance - blockerDistance, 0.0) / blockerDistance;
    const float radius = min(searchRadius * min(ratio, 1e9), scales.largestRadius);
    float lit = 0.0;
    UNITY_LOOP
    for (i = 0; i < count; ++i)
    {
        const float2 offset = RotateDisk(GodotDisk(i, count), rotation) * radius;
        lit += LitByGather(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, prepared.centre + offset,
                           prepared.depth);
    }
    return SanitizeVisibility(MeanVisibility(lit, float(count)));
}

#endif
