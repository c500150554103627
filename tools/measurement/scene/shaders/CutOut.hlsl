// Penumbra tools: where a cut-out surface is open.
//
// Computes:   whether a triangle is open at texture coordinates: the formulas of AlphaPattern and CutOut
//             (tools/measurement/scene/material.h), step by step as tools/measurement/scene/cut_out.cpp computes them
//             for rays.
// Inputs:     _TexCoords: two floats per vertex; _CutOutOfTriangle: 1 + the number of its cut-out, 0 for none; _CutOuts:
//             eight words each (CutOuts::Entry); _CutOutTexels: four texels of 8 bits a word, the first in the lowest.
//             The cutoff of blended surfaces is infinite: nothing of them is drawn.
// Cost:       two buffer loads for a triangle without cut-out, up to eight and four texels with one.
// Guarantees: no texel outside of the cut-out's own texture is read.
// Use it:     from the fragment shaders of this folder, where the scene has cut-outs.
#ifndef PENUMBRA_SCENE_CUT_OUT_HLSL
#define PENUMBRA_SCENE_CUT_OUT_HLSL

#include "SceneMesh.hlsl"

StructuredBuffer<float> _TexCoords;
StructuredBuffer<uint> _CutOutOfTriangle;
StructuredBuffer<uint> _CutOuts;
StructuredBuffer<uint> _CutOutTexels;

static const uint kWireGrid = 1;
static const uint kLeaf = 2;
static const uint kHoles = 3;
static const uint kWire = 4;
static const uint kSmoke = 5;
static const uint kRepeat = 0;
static const uint kClamp = 2;

struct CutOut
{
    uint pattern;
    uint firstTexel;
    int2 size;
    uint2 wrap;
    float factor;
    float cutoff;
};

float2 CornerTexCoord(uint corner)
{
    const uint first = 2 * _Indices[corner];
    return float2(_TexCoords[first], _TexCoords[first + 1]);
}

CutOut CutOutAt(uint number)
{
    const uint at = 8 * number;
    CutOut cutOut;
    cutOut.pattern = _CutOuts[at];
    cutOut.firstTexel = _CutOuts[at + 1];
    cutOut.size = int2(_CutOuts[at + 2], _CutOuts[at + 3]);
    cutOut.wrap = uint2(_CutOuts[at + 4], _CutOuts[at + 5]);
    cutOut.factor = asfloat(_CutOuts[at + 6]);
    cutOut.cutoff = asfloat(_CutOuts[at + 7]);
    return cutOut;
}

float PatternAlpha(uint pattern, float2 uv)
{
    const float2 inSquare = uv - floor(uv);
    const float2 fromCentre = abs(inSquare - 0.5);
    float alpha = 1.0;
    if (pattern == kWireGrid)
        alpha = 1.0 - 8.0 * (0.5 - max(fromCentre.x, fromCentre.y));
    else if (pattern == kLeaf)
        alpha = 0.5 + 4.0 * (inSquare.x * (1.0 - inSquare.x) - fromCentre.y);
    else if (pattern == kHoles)
        alpha = 0.5 + 4.0 * (length(fromCentre) - 0.375);
    else if (pattern == kWire)
        alpha = 0.5 + 24.0 * (1.0 / 6.0 - fromCentre.y);
    else if (pattern == kSmoke)
    {
        const float inside = max(1.0 - 4.0 * dot(fromCentre, fromCentre), 0.0);
        alpha = 0.6 * inside * inside;
    }
    return clamp(alpha, 0.0, 1.0);
}

float Wrapped(float coordinate, uint wrap)
{
    if (wrap == kClamp)
        return clamp(coordinate, 0.0, 1.0);
    if (wrap == kRepeat)
        return coordinate - floor(coordinate);
    const float both = coordinate - 2.0 * floor(0.5 * coordinate);
    return both > 1.0 ? 2.0 - both : both;
}

int Neighbour(int texel, int size, uint wrap)
{
    return wrap == kRepeat ? (texel + size) % size : clamp(texel, 0, size - 1);
}

float TexelAlpha(CutOut cutOut, int x, int y)
{
    const uint at = cutOut.firstTexel + uint(y) * uint(cutOut.size.x) + uint(x);
    return float((_CutOutTexels[at / 4] >> (8 * (at % 4))) & 255) / 255.0;
}

float TextureAlpha(CutOut cutOut, float2 uv)
{
    const float x = Wrapped(uv.x, cutOut.wrap.x) * float(cutOut.size.x) - 0.5;
    const float y = Wrapped(uv.y, cutOut.wrap.y) * float(cutOut.size.y) - 0.5;
    const int column = int(floor(x));
    const int row = int(floor(y));
    const int left = Neighbour(column, cutOut.size.x, cutOut.wrap.x);
    const int right = Neighbour(column + 1, cutOut.size.x, cutOut.wrap.x);
    const int top = Neighbour(row, cutOut.size.y, cutOut.wrap.y);
    const int bottom = Neighbour(row + 1, cutOut.size.y, cutOut.wrap.y);
    const float across = x - floor(x);
    const float down = y - floor(y);
    const float above = TexelAlpha(cutOut, left, top) * (1.0 - across) + TexelAlpha(cutOut, right, top) * across;
    const float below = TexelAlpha(cutOut, left, bottom) * (1.0 - across) + TexelAlpha(cutOut, right, bottom) * across;
    return above * (1.0 - down) + below * down;
}

bool IsOpen(uint triangleNumber, float2 uv)
{
    const uint number = _CutOutOfTriangle[triangleNumber];
    if (number == 0)
        return false;
    const CutOut cutOut = CutOutAt(number - 1);
    float alpha = cutOut.factor * PatternAlpha(cutOut.pattern, uv);
    if (cutOut.size.x > 0)
        alpha *= TextureAlpha(cutOut, uv);
    return alpha < cutOut.cutoff;
}

#endif
