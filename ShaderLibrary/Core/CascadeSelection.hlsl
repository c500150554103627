// Penumbra: which cascade a point belongs to.
//
// Computes:   the first cascade whose split sphere contains a world position; and how far the position is into the
//             border to the next cascade.
// Source:     the split spheres of Unity's cascades (culling spheres; radii are kept squared). The weight in the border
//             is linear in the squared distance, as URP's fade at the shadow distance is.
// Inputs:     positionWS, metres; sphere centres, metres, world space; squared radii, square metres;
//             count 1..4. Spheres at and beyond `count` are not read.
// Cost:       no fetches.
// Guarantees: returns 0 .. count - 1, or count if no sphere contains the point (NaN positions included). A point
//             exactly on a sphere is outside it. Weights are 0 to 1, exactly 0 without a border, in the last cascade
//             and where the next sphere does not contain the position.
// Use it:     with more than one cascade: URP does not set the spheres for a single cascade. A weight either chooses
//             the cascade of a pixel by noise (dithering: no cost, noise in the border), or mixes the results of both
//             (two evaluations in the border).
#ifndef PENUMBRA_CASCADE_SELECTION_HLSL
#define PENUMBRA_CASCADE_SELECTION_HLSL

#include "FloatBits.hlsl"

static const float kSmallestBorder = 1e-3;

struct CascadeSpheres
{
    float3 centre0;
    float3 centre1;
    float3 centre2;
    float3 centre3;
    float4 squaredRadii;
};

int SelectCascade(float3 positionWS, CascadeSpheres spheres, int count)
{
    const float3 d0 = positionWS - spheres.centre0;
    const float3 d1 = positionWS - spheres.centre1;
    const float3 d2 = positionWS - spheres.centre2;
    const float3 d3 = positionWS - spheres.centre3;
    if (dot(d0, d0) < spheres.squaredRadii.x) return 0;
    if (count > 1 && dot(d1, d1) < spheres.squaredRadii.y) return 1;
    if (count > 2 && dot(d2, d2) < spheres.squaredRadii.z) return 2;
    if (count > 3 && dot(d3, d3) < spheres.squaredRadii.w) return 3;
    return count;
}

// Weight of the cascade behind `cascade`, which SelectCascade returned. border: share of the sphere's radius.
float NextCascadeWeight(float3 positionWS, CascadeSpheres spheres, int cascade, int count, float border)
{
    const float share = BoundedOrLow(border, 0.0, 1.0);
    if (cascade + 1 >= count || share < kSmallestBorder) return 0.0;
    const float3 d0 = positionWS - spheres.centre0;
    const float3 d1 = positionWS - spheres.centre1;
    const float3 d2 = positionWS - spheres.centre2;
    const float3 d3 = positionWS - spheres.centre3;
    const float4 ratio = float4(dot(d0, d0), dot(d1, d1), dot(d2, d2), dot(d3, d3)) / max(spheres.squaredRadii, 1e-12);
    const float own = cascade == 0 ? ratio.x : cascade == 1 ? ratio.y : ratio.z;
    const float next = cascade == 0 ? ratio.y : cascade == 1 ? ratio.z : ratio.w;
    if (!(next < 1.0)) return 0.0;
    const float begin = (1.0 - share) * (1.0 - share);
    return BoundedOrLow((own - begin) / (1.0 - begin), 0.0, 1.0);
}

#endif
