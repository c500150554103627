// Penumbra: widths of penumbrae and search radii.
//
// Computes:   penumbra and search radii in texels, and the test whether a texel lies in the cone of rays from the
//             receiver to the light's disc.
// Source:     similar triangles; Fernando, "Percentage-Closer Soft Shadows" (2005), for a directional light:
//
//                  \  disc of angular diameter a  /
//                   \        |--w--|             /     w = tan(a/2) gap: radius of the light's cone at the blocker,
//              ------\-------+-----/----- blocker      hence also of the penumbra
//                     \      |gap /
//                      \     |   /                     A blocker at lateral distance u hides part of the disc
//                 ------\----+--/-------- receiver     iff u < w.
//
// Inputs:     gaps in stored depth, radii in texels of the tile; ShadowTile.
// Cost:       no fetches.
// Guarantees: finite and >= 0 for any tile; radii never exceed the tile.
// Use it:     for any filter that knows the blocker's depth.
#ifndef PENUMBRA_PENUMBRA_HLSL
#define PENUMBRA_PENUMBRA_HLSL

#include "DepthConvention.hlsl"
#include "FloatBits.hlsl"
#include "ShadowStructs.hlsl"

// The tile's scales, bounded, per texel of the tile instead of per tile UV.
struct ConeScales
{
    float texelsPerDepth;  // penumbra radius, texels, per unit of stored depth gap
    float depthPerTexel;   // its inverse, 0 at angular diameter 0
    float texelsPerMetre;  // across the light
    float depthPerMetre;   // along it
    float largestRadius;   // texels: no kernel is wider than its tile
};

ConeScales ConeScalesOf(ShadowTile tile)
{
    // Tiles are square in texels, whatever the shape of the atlas.
    const float tileTexels = min(max(FiniteOr(tile.offsetScale.z * tile.atlasTexelSize.z, 1.0), 1.0), 65536.0);
    ConeScales scales;
    scales.texelsPerDepth = BoundedOrLow(tile.depthToRadial, 0.0, 1e9) * tileTexels;
    scales.depthPerTexel = BoundedOrLow(tile.radialToDepth, 0.0, 1e9) / tileTexels;
    scales.texelsPerMetre = BoundedOrLow(tile.uvPerMetre, 0.0, 1e9) * tileTexels;
    scales.depthPerMetre = BoundedOrLow(tile.depthPerMetre, 0.0, 1e9);
    scales.largestRadius = tileTexels;
    return scales;
}

// Radius of the penumbra at the receiver, texels, for a blocker `gap` nearer to the light.
float PenumbraRadius(float gap, ConeScales scales)
{
    return min(max(gap, 0.0) * scales.texelsPerDepth, scales.largestRadius);
}

// Radius within which any blocker of the map may hide part of the light, at most for `largestPenumbraMetres` (full
// width, 0 to 1) and at least `floorTexels`.
float SearchRadius(float receiverDepth, float largestPenumbraMetres, float floorTexels, ConeScales scales)
{
    const float bound = 0.5 * BoundedOrLow(largestPenumbraMetres, 0.0, 1e9) * scales.texelsPerMetre;
    const float radius = min(PenumbraRadius(LargestGap(receiverDepth), scales), bound);
    return min(max(radius, floorTexels), scales.largestRadius);
}

float AverageGap(float gapSum, float weightSum)
{
    return weightSum > 0.0 ? gapSum / weightSum : 0.0;
}

// The gap a blocker at lateral distance `radius` (texels) must exceed to lie in the light's cone. A texel is a square,
// not a point, so the first `slack` texels of distance do not count. `largestOffset`: caps the cone's height (depth).
float ConeOffset(float radius, float slack, float largestOffset, ConeScales scales)
{
    return min(max(radius - slack, 0.0) * scales.depthPerTexel, largestOffset);
}

// Lit share of the weighted samples: exactly 1 if nothing blocks, exactly 0 if everything blocks, 1 if the sum of
// weights is 0.
float LitShare(float litWeight, float blockedWeight)
{
    if (!(blockedWeight > 0.0)) return 1.0;
    if (!(litWeight > 0.0)) return 0.0;
    return litWeight / (litWeight + blockedWeight);
}

// Mean of `count` visibilities, exact at both ends: count * (1 / count) is not 1 for every count.
float MeanVisibility(float sum, float count)
{
    return sum >= count ? 1.0 : max(sum, 0.0) / count;
}

#endif
