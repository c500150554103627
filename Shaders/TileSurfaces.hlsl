// Penumbra: the surfaces that the camera sees in a tile of 16 x 16 pixels, by a group of as many threads.
//
// Computes:   ReadCameraSurface (Screen/CameraSurface.hlsl) of each pixel of the tile, from depths that the group reads once.
// Source:     Screen/CameraSurface.hlsl.
// Inputs:     _CameraDepthTexture; ScreenView; the tile's first pixel.
// Cost:       100 gathers for a tile: 0.39 fetches per pixel, where 5 to 9 are needed alone.
// Guarantees: those of CameraSurface.hlsl, and the same values.
// Use it:     in kernels of 16 x 16 threads; all of them call LoadTileDepths.
#ifndef PENUMBRA_TILE_SURFACES_HLSL
#define PENUMBRA_TILE_SURFACES_HLSL

#include "ScreenPass.hlsl"

#define TILE_PIXELS 16
// ReadCameraSurface reads two pixels each way.
#define TILE_APRON 2
#define TILE_SIDE (TILE_PIXELS + 2 * TILE_APRON)

groupshared float tileDepths[TILE_SIDE * TILE_SIDE];

float TileDepth(int2 pixelOfTile)
{
    return tileDepths[(pixelOfTile.y + TILE_APRON) * TILE_SIDE + pixelOfTile.x + TILE_APRON];
}

// In the order of a gather's components: below left, below right, above right, above left, where rows go downwards.
int2 GatheredTexel(int component)
{
    return int2(component == 1 || component == 2 ? 1 : 0, component < 2 ? 1 : 0);
}

void LoadTileDepths(int2 firstPixel, uint thread, ScreenView view, SAMPLER(sampler_point))
{
    const int2 last = int2(view.size.xy) - 1;
    if (thread < TILE_SIDE * TILE_SIDE / 4)
    {
        const int2 quad = 2 * int2(int(thread) % (TILE_SIDE / 2), int(thread) / (TILE_SIDE / 2));
        const int2 pixel = firstPixel - TILE_APRON + quad;
        const float4 depths = GATHER_RED_TEXTURE2D_X(_CameraDepthTexture, sampler_point, float2(pixel + 1) * view.size.zw);
        UNITY_UNROLL
        for (int i = 0; i < 4; ++i)
        {
            const int2 texel = quad + GatheredTexel(i);
            const int2 at = pixel + GatheredTexel(i);
            const bool inside = all(at >= 0) && all(at <= last);
            tileDepths[texel.y * TILE_SIDE + texel.x] = inside ? depths[i] : 0.0;
        }
    }
    GroupMemoryBarrierWithGroupSync();
}

float TileDepthSlope(int2 pixelOfTile, int2 direction, float depth)
{
    DepthLine along;
    along.before = TileDepth(pixelOfTile - direction);
    along.here = depth;
    along.after = TileDepth(pixelOfTile + direction);
    if (!ContradictsItself(along)) return NearerSlope(along);
    return StraighterSlope(TileDepth(pixelOfTile - 2 * direction), along, TileDepth(pixelOfTile + 2 * direction));
}

CameraSurface TileSurface(int2 firstPixel, int2 pixelOfTile, ScreenView view)
{
    const float depth = TileDepth(pixelOfTile);
    float2 slope = float2(kNoDepthSlope, kNoDepthSlope);
    if (IsSurfaceDepth(depth))
    {
        slope.x = TileDepthSlope(pixelOfTile, int2(1, 0), depth);
        slope.y = TileDepthSlope(pixelOfTile, int2(0, 1), depth);
    }
    return SurfaceWithSlope(view, firstPixel + pixelOfTile, depth, slope);
}

#endif
