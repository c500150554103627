// Penumbra: which pixel of the screen corresponds to a pixel of a half-resolution image.
//
// Computes:   the pixel of the full screen at which a half-resolution pixel is evaluated, and the half-resolution
//             pixels around a full one.
//
//                 full      0   1   2   3   4        half pixel i is evaluated at full pixel 2 i + 1: odd pixels are
//                 half          0       1   (2)      copies, even ones lie midway between two
//
// Source:     geometry.
// Inputs:     pixel coordinates from 0; scale: pixels of the screen per pixel of the image, 1 or 2.
// Cost:       no fetches.
// Guarantees: the result lies on the screen, also in the last row and column of a screen of odd size.
// Use it:     wherever images of two resolutions are combined, so that both refer to the same pixels.
#ifndef PENUMBRA_SCREEN_SCALE_HLSL
#define PENUMBRA_SCREEN_SCALE_HLSL

// Pixels of the screen per pixel of an image that is ceil(full / scale) wide.
int ScreenScale(float fullWidth, float width)
{
    return max(int(fullWidth / max(width, 1.0) + 0.5), 1);
}

int2 FullPixel(int2 pixel, int scale, int2 fullSize)
{
    return min(pixel * scale + (scale >> 1), fullSize - 1);
}

// The first of the two half-resolution pixels around full pixel x of one axis; -1 for pixels before the image's first.
int HalfPixelBefore(int full)
{
    return ((full + 1) >> 1) - 1;
}

#endif
