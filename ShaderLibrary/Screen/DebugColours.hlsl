// Penumbra: colours for numbers, for debug views.
//
// Computes:   a colour for a cascade, a length, the size of a shadow texel, and the chequers of the shadow map's
//             texels.
// Source:     black body colours for lengths: the larger, the brighter. Cascades have colours of Okabe and Ito, "Color
//             Universal Design" (2008), which colour-blind people can tell apart and which are light enough for the
//             shadow to show under them; texel sizes blend between three of them.
// Inputs:     cascade 0 to 3; metres; screen pixels; texel coordinates of the atlas.
// Cost:       no fetches.
// Guarantees: [0, 1] for any input; NaN counts as 0.
// Use it:     for pictures that people look at. Not: for anything that is measured.
#ifndef PENUMBRA_DEBUG_COLOURS_HLSL
#define PENUMBRA_DEBUG_COLOURS_HLSL

#include "../Core/FloatBits.hlsl"

static const float kShortestShownMetres = 0.01;
static const float kLongestShownMetres = 1.0;
static const float kCoarsestShownPixels = 8.0;

// Sky blue, orange, green and purple stand for the cascades. Any other number is no cascade, and dark grey.
float3 CascadeColour(int cascade)
{
    if (cascade == 0) return float3(0.337, 0.706, 0.914);
    if (cascade == 1) return float3(0.902, 0.624, 0.0);
    if (cascade == 2) return float3(0.0, 0.62, 0.451);
    if (cascade == 3) return float3(0.8, 0.475, 0.655);
    return float3(0.25, 0.25, 0.25);
}

// The colour is black at 0, red at 1/3, yellow at 2/3 and white at 1.
float3 HeatColour(float share)
{
    const float heat = 3.0 * BoundedOrLow(share, 0.0, 1.0);
    return float3(min(heat, 1.0), min(max(heat - 1.0, 0.0), 1.0), max(heat - 2.0, 0.0));
}

// Equal steps stand for equal ratios: 1 cm is 0, 10 cm one half, 1 m and more 1.
float LengthShare(float metres)
{
    const float shown = BoundedOrLow(metres, kShortestShownMetres, kLongestShownMetres);
    return log2(shown / kShortestShownMetres) / log2(kLongestShownMetres / kShortestShownMetres);
}

// The colour says how many pixels of the screen a shadow texel is wide: blue up to 1, then yellow, vermilion from 8.
float3 TexelSizeColour(float pixels)
{
    const float share = log2(BoundedOrLow(pixels, 1.0, kCoarsestShownPixels)) / log2(kCoarsestShownPixels);
    const float3 fine = float3(0.0, 0.447, 0.698);
    const float3 middle = float3(0.941, 0.894, 0.259);
    const float3 coarse = float3(0.835, 0.369, 0.0);
    return share < 0.5 ? lerp(fine, middle, 2.0 * share) : lerp(middle, coarse, 2.0 * share - 1.0);
}

// Alternates between 1 and 0, one texel each.
float TexelChequer(float2 texels)
{
    const int2 texel = int2(floor(float2(BoundedOrLow(texels.x, 0.0, 65536.0), BoundedOrLow(texels.y, 0.0, 65536.0))));
    return float((texel.x + texel.y) & 1);
}

#endif
