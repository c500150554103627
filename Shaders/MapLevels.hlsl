// Penumbra: mip levels of maps that may be filtered.
//
// Computes:   a level's texel, the mean of four of the level before; and the first level, the map's values.
// Source:     Williams, "Pyramidal Parametrics", 1983.
// Inputs:     those of MapPasses.hlsl; _PenumbraSourceTexture: of a level, the one before.
// Cost:       1 fetch per texel of the first level, 4 of each other: 7/3 per texel of the map.
// Guarantees: texels lie in one tile up to the level that Map/MapLevels.hlsl names the coarsest.
// Use it:     as passes that run for each cascade. Not: over the screen.
#ifndef PENUMBRA_MAP_LEVELS_PASS_HLSL
#define PENUMBRA_MAP_LEVELS_PASS_HLSL

float4 FirstLevel(ScreenVaryings input) : SV_Target
{
    return MapValue(LOAD_TEXTURE2D(_MainLightShadowmapTexture, int2(input.positionCS.xy)).x);
}

float4 NextLevel(ScreenVaryings input) : SV_Target
{
    const int2 first = 2 * int2(input.positionCS.xy);
    return 0.25 * (LOAD_TEXTURE2D_X(_PenumbraSourceTexture, first) +
                   LOAD_TEXTURE2D_X(_PenumbraSourceTexture, first + int2(1, 0)) +
                   LOAD_TEXTURE2D_X(_PenumbraSourceTexture, first + int2(0, 1)) +
                   LOAD_TEXTURE2D_X(_PenumbraSourceTexture, first + int2(1, 1)));
}

#endif
