// Penumbra: places in a map of a cloud layer.
//
// Computes:   CloudUv      where the ray from a receiver to the sun's centre meets the layer, as texture coordinates
//             CloudWeight  how much of the map's shadow counts there: 1 in its middle, falling to 0 at its border
// Source:     Candycat, "Graphics Study: RDR2, shadows" (2021): clouds are drawn into a map from the light, whose
//             shadow is blended out at the map's border. Here the layer is a level plane, so that the map is the layer
//             seen from above and stays the same while the sun moves.
// Inputs:     CloudLayer, by BoundedCloudLayer; the receiver, world space, metres; the direction towards the sun, of
//             any positive length.
// Cost:       no fetches.
// Guarantees: finite for any input; the weight is in [0, 1], and 0 for a receiver over the layer, one that is not
//             finite, or a sun less than a tenth of a degree over the horizontal.
// Use it:     for layers whose thickness is small against their height. Not: for towering clouds, or a camera among
//             them.
#ifndef PENUMBRA_CLOUD_LAYER_HLSL
#define PENUMBRA_CLOUD_LAYER_HLSL

#include "FloatBits.hlsl"

struct CloudLayer
{
    float2 corner; // metres, x and z
    float2 size;   // metres along x and z
    float height;  // height of the plane, metres
    float border;  // share of the map over which its shadow fades, on each side
};

// area: the corner's x and z, then the size.
CloudLayer BoundedCloudLayer(float4 area, float height, float border)
{
    CloudLayer layer;
    layer.corner = float2(BoundedOrLow(area.x, -1e7, 1e7), BoundedOrLow(area.y, -1e7, 1e7));
    layer.size = float2(BoundedOrLow(area.z, 1e-3, 1e7), BoundedOrLow(area.w, 1e-3, 1e7));
    layer.height = BoundedOrLow(height, -1e5, 1e5);
    layer.border = BoundedOrLow(border, 0.0, 0.5);
    return layer;
}

// A square map that is centred on the place through which the sun shines on the camera, so that it covers receivers
// around the camera. Its corner lies on a whole number of texels, so that clouds keep their place while the camera
// moves.
CloudLayer CloudLayerAround(float3 cameraWS, float3 towardSun, float height, float mapMetres, float border,
                            float texels)
{
    const float size = BoundedOrLow(mapMetres, 1.0, 1e6);
    const float texel = size / BoundedOrLow(texels, 1.0, 16384.0);
    const float rise = max(BoundedOrLow(height, -1e5, 1e5) - BoundedOrLow(cameraWS.y, -1e5, 1e5), 0.0);
    const float slope = rise / max(FiniteOr(towardSun.y, 1.0), 1e-3);
    const float2 centre = float2(BoundedOrLow(cameraWS.x + slope * towardSun.x, -5e6, 5e6),
                                 BoundedOrLow(cameraWS.z + slope * towardSun.z, -5e6, 5e6));
    const float2 corner = floor((centre - 0.5 * size) / texel) * texel;
    return BoundedCloudLayer(float4(corner, size, size), height, border);
}

// The distance to the layer along the direction towards the sun, in lengths of that direction; negative where the ray
// does not meet the layer.
float WayToLayer(float3 positionWS, float3 towardSun, CloudLayer layer)
{
    const float level = dot(towardSun.xz, towardSun.xz);
    const bool high = towardSun.y > 0.0 && towardSun.y * towardSun.y > 3.05e-6 * level; // tan of 0.1 degrees, squared
    const float sum = positionWS.x + positionWS.y + positionWS.z + towardSun.x + towardSun.y + towardSun.z;
    if (!high || !HasFiniteBits(sum)) return -1.0;
    const float rise = layer.height - positionWS.y;
    return rise >= 0.0 ? rise / towardSun.y : -1.0;
}

float2 CloudUv(float3 positionWS, float3 towardSun, CloudLayer layer)
{
    const float way = max(WayToLayer(positionWS, towardSun, layer), 0.0);
    const float2 place = float2(FiniteOr(positionWS.x + way * towardSun.x, 0.0),
                                FiniteOr(positionWS.z + way * towardSun.z, 0.0));
    return min(max((place - layer.corner) / layer.size, -1e6), 1e6);
}

float CloudWeight(float3 positionWS, float3 towardSun, CloudLayer layer)
{
    if (WayToLayer(positionWS, towardSun, layer) < 0.0) return 0.0;
    const float2 uv = CloudUv(positionWS, towardSun, layer);
    const float2 inside = min(uv, 1.0 - uv); // distance to the nearer side
    const float least = min(inside.x, inside.y);
    if (least < 0.0) return 0.0;
    return layer.border > 0.0 ? min(least / layer.border, 1.0) : 1.0;
}

#endif
