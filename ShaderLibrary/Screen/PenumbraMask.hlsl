// Penumbra: a quarter-resolution mask of where a shadow's edge may lie.
//
// Computes:   which pixels of a block are sampled, and from their visibilities whether it contains an edge.
//
//                 . 0 . .      four comparison taps per block, one in each row and column
//                 . . . 1
//                 2 . . .
//                 . . 3 .
//
// Source:     the mask of deferred shadowing passes: mark coarsely where comparisons disagree, then filter there only.
// Inputs:     block: pixel of the mask. Visibilities of single comparisons at the taps' surfaces, 1 where there is
//             none: the sky is lit.
// Cost:       no fetches; the taps are the caller's: 4 camera depths and 4 comparisons per block, 0.5 per pixel.
// Guarantees: exactly 0 or 1; tap pixels lie on the screen. Not conservative: a shadow thinner than the gap between
//             taps can be missed. Shaders/ConservativeMaskPass.hlsl misses none; where it knows a block's visibility
//             its mask holds that, too.
// Use it:     before MaskBlur.hlsl. Not: alone, since a penumbra is wider than its edge.
#ifndef PENUMBRA_PENUMBRA_MASK_HLSL
#define PENUMBRA_PENUMBRA_MASK_HLSL

static const int kMaskBlock = 4;
static const int kMaskTaps = 4;

// These are what a mask says of a block. Values below 0.5 mean that no penumbra is there; a texel of 8 bits tells them
// apart.
static const float kMaskCompareOnce = 0.0; // one comparison tells whether the block is lit
static const float kMaskAllDark = 0.125;
static const float kMaskAllLit = 0.25;
static const float kMaskFilter = 1.0;

bool MaskSkipsFilter(float mask)
{
    return mask < 0.5;
}

// The visibility of the whole block; negative where a comparison must tell.
float MaskedVisibility(float mask)
{
    if (mask > 0.5 * (kMaskAllDark + kMaskAllLit)) return 1.0;
    return mask > 0.5 * kMaskAllDark ? 0.0 : -1.0;
}

int2 MaskTapPixel(int2 block, int tap, int2 screenSize)
{
    const int column = tap == 0 ? 1 : (tap == 1 ? 3 : (tap == 2 ? 0 : 2));
    return min(block * kMaskBlock + int2(column, tap), screenSize - 1);
}

int2 MaskBlockOf(int2 pixel)
{
    return int2(uint2(pixel) / uint(kMaskBlock));
}

// Hardware filters in steps of 1/256, so values within half a step of 0 or 1 count as 0 or 1.
float MaskOf(float4 visibilities)
{
    const float halfStep = 0.001953125;
    const bool allLit = all(visibilities >= 1.0 - halfStep);
    const bool allDark = all(visibilities <= halfStep);
    return allLit || allDark ? kMaskCompareOnce : kMaskFilter;
}

#endif
