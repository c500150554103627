// Stands in for HDRP's file of this name (17): a blocker search and a filter on one line across the light, written for
// tests. It reads the shader data by HDRP's rules: distances in tile UV, heights in stored depth, reversed.
#ifndef STANDS_IN_FOR_HD_SHADOW_SAMPLING
#define STANDS_IN_FOR_HD_SHADOW_SAMPLING

#if !defined(DIRECTIONAL_SHADOW_HIGH)
#error HDRP has its PCSS at high quality only
#endif

#if !defined(STAND_IN_HDRP_17)
// Version 14 filters in another way, which no test runs.
float StandInPcss(HDShadowData data, float3 at, float2 pixel, Texture2D map, SamplerComparisonState compare,
                  SamplerState plain)
{
    return 1.0;
}
#else

// In [-1, 1], moved by the pixel's noise of this frame.
float StandInOffset(int i, int count, float2 pixel)
{
    return 2.0 * (float(i) + InterleavedGradientNoise(pixel, int(_TaaFrameInfo.z))) / float(count) - 1.0;
}

float StandInPcss(HDShadowData data, float3 at, float2 pixel, Texture2D map, SamplerComparisonState compare,
                  SamplerState plain)
{
    const float2 across = float2(data.shadowMapSize.x * _CascadeShadowAtlasSize.z, 0.0);
    const float farthest = data.dirLightPCSSParams0.z * abs(data.proj.z);
    const float reach = min(1.0 - at.z, farthest) * data.dirLightPCSSParams0.x;
    const int searched = asint(data.shadowFilterParams0.y);
    float depth = 0.0;
    float found = 0.0;
    for (int i = 0; i < searched; ++i)
    {
        const float2 uv = at.xy + StandInOffset(i, searched, pixel) * reach * across;
        const float stored = SAMPLE_TEXTURE2D_LOD(map, plain, uv, 0.0).x;
        if (stored > at.z)
        {
            depth += stored;
            found += 1.0;
        }
    }
    if (found == 0.0) return 1.0;

    const float radius = min(depth / found - at.z, farthest) * data.dirLightPCSSParams0.x;
    const int filtered = asint(data.shadowFilterParams0.z);
    float lit = 0.0;
    for (int k = 0; k < filtered; ++k)
    {
        const float2 uv = at.xy + StandInOffset(k, filtered, pixel) * radius * across;
        lit += SAMPLE_TEXTURE2D_SHADOW(map, compare, float3(uv, at.z));
    }
    return lit / float(filtered);
}
#endif

#endif
