// Penumbra: keeping every fetch inside its cascade's tile.
//
// Computes:   the coordinate nearest to a given one at which a fetch reads no texel of a neighbouring tile.
// Source:     geometry. A bilinear footprint reaches half a texel to each side:
//
//                 tile edge
//                 |---0---|---1---|---2---      texels of the tile
//                 |   ^ a footprint centred here, or further right, reads no texel left of the edge
//
// Inputs:     atlas UV; ShadowTile. Texel coordinates are atlas UV times the atlas size.
// Cost:       no fetches.
// Guarantees: the result is finite for any input. Devices keep 8 fractional bits of a texel coordinate and may
//             round it either way, so bilinear footprints are kept 1/64 texel further inside than exact arithmetic
//             requires; a quad of four texels is addressed at its corner and needs no such margin.
// Use it:     before every sample. Not: as a test whether a receiver lies in a cascade.
#ifndef PENUMBRA_TILE_BOUNDS_HLSL
#define PENUMBRA_TILE_BOUNDS_HLSL

#include "FloatBits.hlsl"
#include "ShadowStructs.hlsl"

static const float kBilinearMarginTexels = 0.515625; // 1/2 + 1/64

struct TileBounds
{
    float2 minimum; // texel coordinates
    float2 maximum;
};

TileBounds BoundsInTexels(ShadowTile tile)
{
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    const float2 origin = min(max(FiniteOr(tile.offsetScale.xy, float2(0.0, 0.0)), 0.0), 1.0);
    const float2 extent = min(max(FiniteOr(tile.offsetScale.zw, float2(1.0, 1.0)), 0.0), 1.0 - origin);
    // Tile borders are at whole texels; rounding removes the error of the product of two floats.
    TileBounds bounds;
    bounds.minimum = floor(origin * size + 0.5);
    bounds.maximum = floor((origin + extent) * size + 0.5);
    return bounds;
}

// Texel coordinates (atlas UV times atlas size) of a receiver; NaN and infinities go to the tile's corner.
float2 TexelCoordinates(float2 atlasUV, ShadowTile tile)
{
    const TileBounds bounds = BoundsInTexels(tile);
    const float2 size = max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    const float2 texels = FiniteOr(atlasUV * size, bounds.minimum);
    return min(max(texels, bounds.minimum), bounds.maximum);
}

// The position nearest to `texels` whose bilinear footprint stays inside the tile.
float2 ClampFootprint(float2 texels, TileBounds bounds)
{
    const float2 middle = 0.5 * (bounds.minimum + bounds.maximum);
    const float2 low = min(bounds.minimum + kBilinearMarginTexels, middle);
    const float2 high = max(bounds.maximum - kBilinearMarginTexels, middle);
    return min(max(FiniteOr(texels, middle), low), high);
}

// The corner (whole texel coordinates) shared by the four texels of the quad nearest to `texels`.
float2 ClampQuadCorner(float2 texels, TileBounds bounds)
{
    const float2 corner = floor(FiniteOr(texels, bounds.minimum) + 0.5);
    return max(min(corner, bounds.maximum - 1.0), bounds.minimum + 1.0);
}

#endif
