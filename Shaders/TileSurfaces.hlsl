// Penumbra: the surfaces that the camera sees in a square of pixels, by a group of threads.
//
// Computes:   ReadCameraSurface (Screen/CameraSurface.hlsl) of each pixel of the square, from depths that the group reads once.
// Source:     Screen/CameraSurface.hlsl.
// Inputs:     _CameraDepthTexture; ScreenView; the square's first pixel, of an even place, and its even width.
// Cost:       100 gathers for 16 x 16 pixels, 324 for 32 x 32: 0.39 and 0.32 fetches per pixel, where 5 to 9 are needed alone.
// Guarantees: those of CameraSurface.hlsl, and the same values.
// Use it:     in kernels, all threads of which call LoadScreenDepths.
#ifndef PENUMBRA_TILE_SURFACES_HLSL
#define PENUMBRA_TILE_SURFACES_HLSL

#include "ScreenPass.hlsl"

// ReadCameraSurface reads two pixels each way.
#define SQUARE_APRON 2
#define WIDEST_SQUARE 32
// The kernels use the same memory for texels of the shadow map once the surfaces are known.
#define SHARED_DEPTHS 1444

groupshared float sharedDepths[SHARED_DEPTHS];

struct ScreenSquare
{
    int2 first; // pixel
    int width;  // pixels, at most WIDEST_SQUARE
};

float DepthInSquare(ScreenSquare square, int2 pixelOfSquare)
{
    return sharedDepths[(pixelOfSquare.y + SQUARE_APRON) * (square.width + 2 * SQUARE_APRON) + pixelOfSquare.x + SQUARE_APRON];
}

// In the order of a gather's components: below left, below right, above right, above left, where rows go downwards.
int2 GatheredTexel(int component)
{
    return int2(component == 1 || component == 2 ? 1 : 0, component < 2 ? 1 : 0);
}

void LoadScreenDepths(ScreenSquare square, uint thread, uint threads, ScreenView view, SAMPLER(sampler_point))
{
    const int2 last = int2(view.size.xy) - 1;
    const int side = square.width + 2 * SQUARE_APRON;
    const int quads = side / 2;
    UNITY_LOOP
    for (int n = int(thread); n < quads * quads; n += int(threads))
    {
        const int2 quad = 2 * int2(n % quads, n / quads);
        const int2 pixel = square.first - SQUARE_APRON + quad;
        const float4 depths = GATHER_RED_TEXTURE2D_X(_CameraDepthTexture, sampler_point, float2(pixel + 1) * view.size.zw);
        UNITY_UNROLL
        for (int i = 0; i < 4; ++i)
        {
            const int2 texel = quad + GatheredTexel(i);
            const int2 at = pixel + GatheredTexel(i);
            const bool inside = all(at >= 0) && all(at <= last);
            sharedDepths[texel.y * side + texel.x] = inside ? depths[i] : 0.0;
        }
    }
    GroupMemoryBarrierWithGroupSync();
}

float DepthSlopeInSquare(ScreenSquare square, int2 pixelOfSquare, int2 direction, float depth)
{
    DepthLine along;
    along.before = DepthInSquare(square, pixelOfSquare - direction);
    along.here = depth;
    along.after = DepthInSquare(square, pixelOfSquare + direction);
    if (!ContradictsItself(along)) return NearerSlope(along);
    return StraighterSlope(DepthInSquare(square, pixelOfSquare - 2 * direction), along,
                           DepthInSquare(square, pixelOfSquare + 2 * direction));
}

CameraSurface SurfaceInSquare(ScreenSquare square, int2 pixelOfSquare, ScreenView view)
{
    const float depth = DepthInSquare(square, pixelOfSquare);
    float2 slope = float2(kNoDepthSlope, kNoDepthSlope);
    if (IsSurfaceDepth(depth))
    {
        slope.x = DepthSlopeInSquare(square, pixelOfSquare, int2(1, 0), depth);
        slope.y = DepthSlopeInSquare(square, pixelOfSquare, int2(0, 1), depth);
    }
    return SurfaceWithSlope(view, square.first + pixelOfSquare, depth, slope);
}

#endif
