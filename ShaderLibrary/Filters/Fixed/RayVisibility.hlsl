// Penumbra: the light along a view ray, by a few comparisons with the shadow map.
//
// Computes:   the mean visibility of a directional light along a segment, from one comparison at each of a few places:
//
//                     light
//                   \  \  \  \           of four samples here two are lit: 0.5. A ray is straight in each cascade's map
//                    \##\  \  \          too, so a sample's place there is its place along the segment, and no matrix
//               eye --x--x--o--o--| surface      is multiplied for it
//
// Source:     Toth and Umenhoffer, "Real-time volumetric lighting in participating media" (2009), for samples of the
//             shadow map along the ray, moved by another amount in each pixel. Their weights by extinction are places
//             here, so that each sample counts the same: Core/RaySamples.hlsl.
// Inputs:     shadow map with comparison sampler; ShadowSegment: the ray in the world and in the tile of each of its
//             cascades, by SegmentInTile; RaySampling: how many samples (1 to 64), where each lies in its part of the
//             ray (0.5: the middle; noise of the pixel, where a filter follows), and the optical depth of the fog along
//             the ray (0: equal parts of it).
// Cost:       1 fetch for each sample that a cascade's map covers.
// Guarantees: [0, 1] for any input; 1 beyond the last cascade and where no map covers a place. A comparison has no
//             bias: samples lie in the air.
// Use it:     for fog and shafts of light, once for each pixel of a smaller picture. Not: for the shadow of the surface
//             behind.
#ifndef PENUMBRA_RAY_VISIBILITY_HLSL
#define PENUMBRA_RAY_VISIBILITY_HLSL

#include "FixedPcf.hlsl"
#include "../../Core/CascadeSelection.hlsl"
#include "../../Core/RaySamples.hlsl"

struct RaySampling
{
    int samples;
    float jitter;       // 0 to 1
    float opticalDepth; // extinction times length
};

// A ray's segment in one cascade: shadow coordinates at its begin, and from there to its end.
struct TileSegment
{
    float3 begin;
    float3 span;
    ShadowTile tile;
    bool mapped; // false: the cascade has no map
};

struct ShadowSegment
{
    float3 originWS; // metres
    float3 spanWS;   // way from the origin to the segment's end, metres
    CascadeSpheres spheres; // not read with one cascade
    int cascades;
    TileSegment in0; // segments at and beyond `cascades` are not read
    TileSegment in1;
    TileSegment in2;
    TileSegment in3;
};

// worldToShadow maps world metres to atlas UV and stored depth.
TileSegment SegmentInTile(float4x4 worldToShadow, ShadowTile tile, float3 originWS, float3 spanWS)
{
    TileSegment segment;
    segment.begin = mul(worldToShadow, float4(originWS, 1.0)).xyz;
    segment.span = mul(worldToShadow, float4(spanWS, 0.0)).xyz;
    segment.tile = tile;
    segment.mapped = dot(worldToShadow[0].xyz, worldToShadow[0].xyz) > 0.0;
    return segment;
}

TileSegment SegmentInCascade(ShadowSegment segment, int cascade)
{
    TileSegment chosen = segment.in0;
    if (cascade == 1) chosen = segment.in1;
    if (cascade == 2) chosen = segment.in2;
    if (cascade >= 3) chosen = segment.in3;
    return chosen;
}

float VisibilityInTile(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), TileSegment segment, float share)
{
    const float3 place = segment.begin + share * segment.span;
    const float2 beyond = place.xy - segment.tile.offsetScale.xy;
    const bool inTile = all(beyond >= 0.0) && all(beyond <= segment.tile.offsetScale.zw);
    const bool covered = segment.mapped && inTile && place.z > 0.0 && place.z < 1.0;
    if (!covered) return 1.0;
    ShadowReceiver receiver;
    receiver.shadowCoord = place;
    receiver.depthGradient = float2(0.0, 0.0);
    receiver.rotation = float2(1.0, 0.0);
    return FilterBilinear(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), receiver, segment.tile);
}

float RayVisibility(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowSegment segment, RaySampling sampling)
{
    const int count = BoundedRaySamples(sampling.samples);
    const int cascades = min(max(segment.cascades, 1), 4);
    float sum = 0.0;
    UNITY_LOOP
    for (int i = 0; i < count; ++i)
    {
        const float share = RaySampleShare(i, count, sampling.jitter, sampling.opticalDepth);
        const float3 positionWS = segment.originWS + share * segment.spanWS;
        const int cascade = cascades == 1 ? 0 : SelectCascade(positionWS, segment.spheres, cascades);
        float visibility = 1.0;
        UNITY_BRANCH
        if (cascade < cascades)
        {
            visibility = VisibilityInTile(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap),
                                          SegmentInCascade(segment, cascade), share);
        }
        sum += visibility;
    }
    return SanitizeVisibility(sum / float(count));
}

#endif
