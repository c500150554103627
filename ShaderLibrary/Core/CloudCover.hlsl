// Penumbra: a procedural layer of clouds.
//
// Computes:   CloudTransmittance: the share of light that passes the layer straight up at a place
// Source:     value noise on a lattice of hashed integers, faded as Perlin, "Improving noise" (2002); five octaves,
//             each half as large and half as strong as the one before. Where the sum, scaled to [0, 1], lies above 1 -
//             coverage, there is cloud, whose optical depth grows in proportion: Beer and Lambert.
// Inputs:     CloudCover, by BoundedCloudCover; the place in the layer, x and z, metres.
// Cost:       no fetches; 20 hashes.
// Guarantees: [0, 1] for any input; 1 without coverage or density.
// Use it:     to fill the map of Far/CloudShadow.hlsl where a sky has no clouds of its own. Not: to draw clouds.
#ifndef PENUMBRA_CLOUD_COVER_HLSL
#define PENUMBRA_CLOUD_COVER_HLSL

#include "FloatBits.hlsl"

struct CloudCover
{
    float2 wind;         // metres that the clouds have moved along x and z
    float featureMetres; // size of the largest octave
    float coverage;      // 0: no clouds, 1: clouds everywhere
    float density;       // optical depth where the noise is highest
};

CloudCover BoundedCloudCover(float2 wind, float featureMetres, float coverage, float density)
{
    CloudCover cover;
    cover.wind = float2(BoundedOrLow(wind.x, -1e6, 1e6), BoundedOrLow(wind.y, -1e6, 1e6));
    cover.featureMetres = BoundedOrLow(featureMetres, 1.0, 1e6);
    cover.coverage = BoundedOrLow(coverage, 0.0, 1.0);
    cover.density = BoundedOrLow(density, 0.0, 100.0);
    return cover;
}

// The value at a corner of the lattice, in [0, 1].
float LatticeValue(int2 corner, uint octave)
{
    uint bits = uint(corner.x) * 0x8DA6B343u ^ uint(corner.y) * 0xD8163841u ^ octave * 0xCB1AB31Fu;
    bits ^= bits >> 15;
    bits *= 0x2C1B3C6Du;
    bits ^= bits >> 12;
    bits *= 0x297A2D39u;
    bits ^= bits >> 15;
    return float(bits >> 8) * (1.0 / 16777215.0);
}

float ValueNoise(float2 place, uint octave)
{
    const float2 cell = floor(place);
    const float2 t = place - cell;
    const float2 faded = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    const int2 corner = int2(cell);
    const float low = lerp(LatticeValue(corner, octave), LatticeValue(corner + int2(1, 0), octave), faded.x);
    const float high =
        lerp(LatticeValue(corner + int2(0, 1), octave), LatticeValue(corner + int2(1, 1), octave), faded.x);
    return lerp(low, high, faded.y);
}

float CloudTransmittance(float2 place, CloudCover cover)
{
    const float2 bounded = float2(BoundedOrLow(place.x, -1e7, 1e7), BoundedOrLow(place.y, -1e7, 1e7));
    float2 scaled = (bounded - cover.wind) / cover.featureMetres;
    float sum = 0.0;
    float strength = 16.0 / 31.0; // all five octaves add up to 1
    for (uint octave = 0u; octave < 5u; ++octave)
    {
        sum += strength * ValueNoise(scaled, octave + 1u);
        scaled *= 2.0;
        strength *= 0.5;
    }
    const float thickness = max(sum - (1.0 - cover.coverage), 0.0);
    return exp(-cover.density * thickness / max(cover.coverage, 1e-6));
}

#endif
