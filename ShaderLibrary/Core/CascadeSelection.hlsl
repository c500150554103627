// Penumbra: which cascade a point belongs to.
//
// Computes:   the first cascade whose split sphere contains a world position.
// Source:     the split spheres of Unity's cascades (culling spheres; radii are kept squared).
// Inputs:     positionWS, metres; sphere centres, metres, world space; squared radii, square metres;
//             count 1..4. Spheres at and beyond `count` are not read.
// Cost:       no fetches.
// Guarantees: returns 0 .. count - 1, or count if no sphere contains the point (NaN positions included). A point
//             exactly on a sphere is outside it.
// Use it:     with more than one cascade: URP does not set the spheres for a single cascade.
#ifndef PENUMBRA_CASCADE_SELECTION_HLSL
#define PENUMBRA_CASCADE_SELECTION_HLSL

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

#endif
