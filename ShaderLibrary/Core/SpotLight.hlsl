// Penumbra: depths and penumbrae in the shadow map of a spot light.
//
// Computes:   metres from depths that a map in perspective stores; the radius of a penumbra and of the search for
//             blockers in metres, on the near plane and in tile UV; the scales of the tile at a receiver; and how the
//             light's disc, which faces the receiver, looks in a map whose plane does not.
// Source:     similar triangles, Fernando, "Percentage-Closer Soft Shadows" (2005), for a disc of radius R:
//
//                  ____|____    source, R         An edge at axial depth d_b casts on a receiver at d_r a penumbra of
//                   \  |  /                       radius
//               -----\ | /      d_b, an edge            w = R (d_r - d_b) / d_b = R d_r (1 / d_b - 1 / d_r).
//                     \|/
//                     /|\                         A map from n to f stores 1 / d scaled to 0 .. 1, so with its gap g
//                ____/_|_\____  d_r, receiver     between both depths, w = R d_r g (f - n) / (n f): no division by
//                    2 w                          d_b, and nothing cancels. In tile UV, w / (2 tan(angle / 2) d_r),
//             the depth of the receiver drops out: as under the sun, a penumbra's radius is a constant times the gap,
//             a receiver's plane is a plane, and the cone of rays to the light is a cone.
// Inputs:     SpotMap; stored depths; metres along the light's axis (axial depth); tile UV: 0 to 1 over the map.
// Cost:       no fetches.
// Guarantees: finite for any input, for a map from BoundedSpotMap.
// Use it:     for lights that are points in URP's sense, with a source around it. Not: for the sun.
#ifndef PENUMBRA_SPOT_LIGHT_HLSL
#define PENUMBRA_SPOT_LIGHT_HLSL

#include "DepthConvention.hlsl"
#include "FloatBits.hlsl"
#include "PowersOfTwo.hlsl"
#include "ShadowStructs.hlsl"

// The map of a spot light, and the light's source.
struct SpotMap
{
    float nearMetres; // distance of the map's near plane
    float farMetres;
    float tanHalf;    // tan of half the angle that the map covers
    float sourceRadiusMetres;
};

// The place of a position in the map.
struct SpotCoordinate
{
    bool covered;       // false: behind the light, outside of the map's sides, or not between its planes
    float3 shadowCoord; // atlas UV, stored depth
    float axialMetres;
};

// The cosine of 84 degrees: farther from the axis a source's image is stretched no more.
static const float kSmallestAxisCosine = 0.1;

// packed holds the near and the far plane in metres, tan of half the map's angle, and the source's radius in metres.
SpotMap BoundedSpotMap(float4 packed)
{
    SpotMap map;
    map.nearMetres = BoundedOrLow(packed.x, 1e-6, 1e6);
    map.farMetres = max(BoundedOrLow(packed.y, 1e-6, 1e9), 1.001 * map.nearMetres);
    map.tanHalf = BoundedOrLow(packed.z, 1e-3, 1e3);
    map.sourceRadiusMetres = BoundedOrLow(packed.w, 0.0, 1e6);
    return map;
}

// The slice of an atlas that a spot light's map is: its sides are a power of two of texels, and the light's axis meets
// its middle. worldToShadow is that of ProjectOntoSpotMap. tanHalf is of the light's cone, whose map may be up to a
// third wider.
float4 SliceOfSpotMap(float4x4 worldToShadow, float tanHalf, float4 atlasTexelSize)
{
    const float3 axis = worldToShadow[3].xyz;
    const float squaredAxis = max(dot(axis, axis), 1e-30);
    const float2 middle = float2(dot(worldToShadow[0].xyz, axis), dot(worldToShadow[1].xyz, axis)) / squaredAxis;
    const float uvPerTangent = length(worldToShadow[0].xyz - middle.x * axis) * rsqrt(squaredAxis);
    const float texels = min(max(2.0 * tanHalf * uvPerTangent * atlasTexelSize.z, 1.0), 65536.0);
    const float2 extent = PowerOfTwo(int(floor(log2(texels) + 0.5))) * atlasTexelSize.xy;
    return float4(middle - 0.5 * extent, extent);
}

// Planes and angle of the map in that slice. Stored depth is q + s / d towards the light: q = n / (n - f), s = n f / (f
// - n).
SpotMap SpotMapOfMatrix(float4x4 worldToShadow, float4 slice, float sourceRadiusMetres)
{
    const float3 axis = worldToShadow[3].xyz;
    const float squaredAxis = max(dot(axis, axis), 1e-30);
    const float ofAxis = dot(worldToShadow[2].xyz, axis) / squaredAxis;
    const float q = max(-DepthGap(ofAxis, kFarthestDepth), 1e-9);
    const float s = abs(worldToShadow[2].w - ofAxis * worldToShadow[3].w);
    const float middle = dot(worldToShadow[0].xyz, axis) / squaredAxis;
    const float uvPerTangent = length(worldToShadow[0].xyz - middle * axis) * rsqrt(squaredAxis);
    return BoundedSpotMap(float4(s / (1.0 + q), s / q, 0.5 * slice.z / max(uvPerTangent, 1e-9), sourceRadiusMetres));
}

// 1 / metres per unit of stored depth.
float InverseMetresPerDepth(SpotMap map)
{
    return (map.farMetres - map.nearMetres) / (map.nearMetres * map.farMetres);
}

float AxialDepth(float storedDepth, SpotMap map)
{
    const float aboveFar = min(max(DepthGap(storedDepth, kFarthestDepth), 0.0), 1.0);
    return map.nearMetres * map.farMetres / (map.nearMetres + aboveFar * (map.farMetres - map.nearMetres));
}

// The inverse of AxialDepth, between the planes.
float StoredDepth(float axialMetres, SpotMap map)
{
    const float metres = min(max(axialMetres, map.nearMetres), map.farMetres);
    const float aboveFar = (map.farMetres - metres) / metres * (map.nearMetres / (map.farMetres - map.nearMetres));
    return MoveTowardLight(kFarthestDepth, min(aboveFar, 1.0));
}

// The radius w of the drawing above, across the light at the receiver.
float PenumbraRadiusMetres(float gap, float receiverMetres, SpotMap map)
{
    return map.sourceRadiusMetres * (max(gap, 0.0) * InverseMetresPerDepth(map) * receiverMetres);
}

// The radius w for a blocker on the near plane: no blocker of the map makes a wider one.
float SearchRadiusMetres(float receiverMetres, SpotMap map)
{
    return map.sourceRadiusMetres * (max(receiverMetres - map.nearMetres, 0.0) / map.nearMetres);
}

// The radius, in tile UV, of what a radius at an axial depth covers of the map.
float RadiusInTileUV(float radiusMetres, float axialMetres, SpotMap map)
{
    return radiusMetres / (2.0 * map.tanHalf * axialMetres);
}

// The tile with its scales at a receiver. depthPerMetre is a slope: stored depth is not linear in metres.
ShadowTile TileAtReceiver(ShadowTile tile, SpotMap map, float receiverMetres)
{
    const float inverseMetres = InverseMetresPerDepth(map);
    const float metres = max(receiverMetres, map.nearMetres);
    tile.uvPerMetre = RadiusInTileUV(1.0, metres, map);
    tile.depthPerMetre = 1.0 / (inverseMetres * metres * metres);
    tile.depthToRadial = map.sourceRadiusMetres * inverseMetres / (2.0 * map.tanHalf);
    tile.radialToDepth = tile.depthToRadial > 1e-30 ? 1.0 / tile.depthToRadial : 0.0;
    return tile;
}

// offsetScale is that of ShadowTile. worldToShadow takes world metres to (atlas UV, stored depth) times w, and to w,
// which is the axial depth.
SpotCoordinate ProjectOntoSpotMap(float3 positionWS, float4x4 worldToShadow, float4 offsetScale)
{
    const float4 projected = mul(worldToShadow, float4(positionWS, 1.0));
    SpotCoordinate coordinate;
    coordinate.axialMetres = FiniteOr(projected.w, 0.0);
    const float inverse = 1.0 / max(coordinate.axialMetres, 1e-9);
    coordinate.shadowCoord = float3(FiniteOr(projected.xy * inverse, float2(-1.0, -1.0)),
                                    FiniteOr(projected.z * inverse, kFarthestDepth));
    const float2 fromCorner = coordinate.shadowCoord.xy - offsetScale.xy;
    coordinate.covered = coordinate.axialMetres > 0.0 && coordinate.shadowCoord.z > 0.0 &&
                         coordinate.shadowCoord.z < 1.0 && fromCorner.x >= 0.0 && fromCorner.y >= 0.0 &&
                         fromCorner.x <= offsetScale.z && fromCorner.y <= offsetScale.w;
    return coordinate;
}

// The direction away from the light's axis in tile UV; its length is the sine of the angle to the axis.
float2 AwayFromAxis(float2 tileUV, SpotMap map)
{
    const float2 tangent = (min(max(tileUV, 0.0), 1.0) - 0.5) * (2.0 * map.tanHalf);
    return tangent * rsqrt(1.0 + dot(tangent, tangent));
}

float AxisCosine(float2 awayFromAxis)
{
    return max(sqrt(max(1.0 - dot(awayFromAxis, awayFromAxis), 0.0)), kSmallestAxisCosine);
}

// A disc that faces the receiver, projected through it onto the map, is an ellipse: to first order in R it is 1 / cos
// of the angle to the axis times as long away from the axis as across. The function takes points of the circle to those
// of the ellipse.
float2 StretchAwayFromAxis(float2 offset, float2 awayFromAxis)
{
    const float cosine = AxisCosine(awayFromAxis);
    return offset + awayFromAxis * (dot(awayFromAxis, offset) / (cosine * (1.0 + cosine)));
}

// Squared radius of the circle from which StretchAwayFromAxis takes a point to this one.
float4 SquaredRadiusFacingLight(float4 x, float4 y, float2 awayFromAxis)
{
    const float4 along = awayFromAxis.x * x + awayFromAxis.y * y;
    return max(x * x + y * y - along * along, 0.0);
}

#endif
