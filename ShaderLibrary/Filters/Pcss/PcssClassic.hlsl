// Penumbra: percentage-closer soft shadows, the classic recipe.
//
// Computes:   visibility of a disc light: mean gap of the blockers within a fixed world-space radius, then the lit
//             share of a disc as wide as the penumbra that gap makes. Both discs are Poisson sets, rotated per pixel.
// Source:     Fernando, "Percentage-Closer Soft Shadows" (2005), for a directional light, whose rays do not converge:
//             the penumbra's radius is tan(a/2) times the gap, not lightSize (d_r - d_b) / d_b.
// Inputs:     shadow map (raw reads; the comparison sampler is not used), point sampler; ShadowReceiver; ShadowTile;
//             PcssClassicParameters.
// Cost:       samples fetches where nothing blocks, else twice as many.
// Guarantees: [0, 1] for any input; exactly 1 without blockers, exactly 0 where every texel read blocks; texels outside
//             the tile are not read.
// Use it:     for comparison with existing PCSS implementations. Not: as a first choice; PcssAngular.hlsl adapts the
//             search radius and ignores blockers that cannot hide the light.
#ifndef PENUMBRA_PCSS_CLASSIC_HLSL
#define PENUMBRA_PCSS_CLASSIC_HLSL

#include "../Taps/TexelQuad.hlsl"
#include "../../Core/Disk.hlsl"
#include "Parameters/PcssClassicParameters.hlsl"

float FilterPcssClassic(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                        ShadowReceiver receiver, ShadowTile tile, PcssClassicParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const QuadReceiver prepared = PrepareQuads(receiver, tile);
    const float2 rotation = UnitRotation(receiver.rotation);
    const float smallestRadius = BoundedOrLow(parameters.minFilterTexels, 0.0, 64.0);
    const int count = PoissonSetSize(parameters.samples);

    // The disc has no cone: every texel above the plane and nearer to the light blocks.
    LightCone disc;
    disc.scales = scales;
    disc.slackTexels = 0.0;
    disc.largestOffset = 0.0;

    const float searchRadius = min(max(BoundedOrLow(parameters.searchRadiusMetres, 0.0, 1e6) * scales.texelsPerMetre,
                                       smallestRadius), scales.largestRadius);
    float gapSum = 0.0;
    float blockers = 0.0;
    int i;
    UNITY_LOOP
    for (i = 0; i < count; ++i)
    {
        const float2 offset = RotateDisk(PoissonDisk(i, count), rotation) * searchRadius;
        const TexelQuad quad = ReadQuad(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, disc,
                                        prepared.centre + offset);
        const float4 counted = quad.blocking * quad.weight;
        gapSum += dot(quad.gap, counted);
        blockers += dot(counted, float4(1.0, 1.0, 1.0, 1.0));
    }
    if (!(blockers > 0.0)) return 1.0;

    const float radius = max(PenumbraRadius(AverageGap(gapSum, blockers), scales), smallestRadius);
    float lit = 0.0;
    float blocked = 0.0;
    UNITY_LOOP
    for (i = 0; i < count; ++i)
    {
        const float2 offset = RotateDisk(PoissonDisk(i, count), rotation) * radius;
        const TexelQuad quad = ReadQuad(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, disc,
                                        prepared.centre + offset);
        blocked += dot(quad.weight, quad.blocking);
        lit += dot(quad.weight, 1.0 - quad.blocking);
    }
    return SanitizeVisibility(LitShare(lit, blocked));
}

#endif
