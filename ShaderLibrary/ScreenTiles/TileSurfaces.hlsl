// Penumbra: the surfaces that the camera sees at pixels of the target, from depths that a group of threads reads once.
//
// Computes:   ReadCameraSurface (Screen/CameraSurface.hlsl) of each pixel in a square of the screen, or of one pixel of
//             the target alone, which at half resolution is every second one of the screen.
// Source:     Screen/CameraSurface.hlsl.
// Inputs:     the camera's depth; ScreenView; width of the target; the square.
// Cost:       of a square 100 gathers for 16 x 16 pixels, 324 for 32 x 32: 0.39 and 0.32 fetches per pixel, where 5 to
//             9 are needed alone; at half resolution, where every fourth pixel is needed, 1.27. One pixel: 2 gathers,
//             and up to 4 loads more at edges.
// Guarantees: those of CameraSurface.hlsl, and the same values.
// Use it:     in kernels, all threads of which call LoadScreenDepths.
#ifndef PENUMBRA_TILE_SURFACES_HLSL
#define PENUMBRA_TILE_SURFACES_HLSL

#include "../Core/FastLoop.hlsl"
#include "../Core/RowOrder.hlsl"
#include "../Core/ScreenScale.hlsl"
#include "../Screen/GatheredDepth.hlsl"

// ReadCameraSurface reads two pixels each way.
#define SQUARE_APRON 2
#define WIDEST_SQUARE 32
// The kernels use the same memory for texels of the shadow map once the surfaces are known.
#define SHARED_DEPTHS 1444

groupshared float sharedDepths[SHARED_DEPTHS];

struct ScreenSquare
{
    int2 first; // first pixel of the screen, with even coordinates
    int width;  // pixels, even, at most WIDEST_SQUARE; 0: the square is empty
};

float DepthInSquare(ScreenSquare square, int2 pixelOfSquare)
{
    return sharedDepths[(pixelOfSquare.y + SQUARE_APRON) * (square.width + 2 * SQUARE_APRON) + pixelOfSquare.x +
                        SQUARE_APRON];
}

// The components of a gather are in the order below left, below right, above right, above left, where rows go
// downwards.
int2 GatheredTexel(int component)
{
    return int2(component == 1 || component == 2 ? 1 : 0, component < 2 ? 1 : 0);
}

// The number of the screen's pixels to one of the target, along each axis: 1, or 2 at half resolution.
int TargetScale(ScreenView view, float targetWidth)
{
    return ScreenScale(view.size.x, targetWidth);
}

// The pixel of the screen that one of the target stands for.
int2 PixelOfScreen(int2 pixelOfTarget, ScreenView view, float targetWidth)
{
    return FullPixel(pixelOfTarget, TargetScale(view, targetWidth), int2(view.size.xy));
}

// The surface at a pixel of the screen that shares no depths with its neighbours.
CameraSurface SurfaceAt(TEXTURE2D_X_FLOAT(cameraDepth), SAMPLER(sampler_point), ScreenView view, int2 pixel)
{
    const DepthAndSlope read = GatherDepthAndSlope(cameraDepth, sampler_point, view, pixel);
    return SurfaceWithSlope(view, pixel, read.depth, read.slope);
}

void LoadScreenDepths(TEXTURE2D_X_FLOAT(cameraDepth), SAMPLER(sampler_point), ScreenView view, ScreenSquare square,
                      uint thread, uint threads)
{
    const int2 last = int2(view.size.xy) - 1;
    const int side = square.width + 2 * SQUARE_APRON;
    const int quads = side >> 1;
    PENUMBRA_LOOP
    for (int n = int(thread); n < quads * quads; n += int(threads))
    {
        const int2 quad = 2 * PlaceInRows(n, quads);
        const int2 pixel = square.first - SQUARE_APRON + quad;
        const float4 depths = GATHER_RED_TEXTURE2D_X(cameraDepth, sampler_point,
                                                     float2(pixel + 1) * view.size.zw);
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

// pixel is a pixel of the screen, in the square.
CameraSurface SurfaceInSquare(ScreenSquare square, int2 pixel, ScreenView view)
{
    const int2 pixelOfSquare = pixel - square.first;
    const float depth = DepthInSquare(square, pixelOfSquare);
    float2 slope = float2(kNoDepthSlope, kNoDepthSlope);
    if (IsSurfaceDepth(depth))
    {
        slope.x = DepthSlopeInSquare(square, pixelOfSquare, int2(1, 0), depth);
        slope.y = DepthSlopeInSquare(square, pixelOfSquare, int2(0, 1), depth);
    }
    return SurfaceWithSlope(view, pixel, depth, slope);
}

#endif
