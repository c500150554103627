// The passes of Means.technique.json over the shadow map, a cascade's tile at a time.
#include "Packages/com.penumbra.shadows/Shaders/ScreenPass.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Pipelines/Urp.hlsl"
float4 _PenumbraTile;
float4 Depths(ScreenVaryings input) : SV_Target
{
    return LOAD_TEXTURE2D(_MainLightShadowmapTexture, int2(input.positionCS.xy)).x;
}
float MeanAlong(int2 texel, int2 direction)
{
    const int2 low = int2(_PenumbraTile.xy);
    const int2 high = low + int2(_PenumbraTile.zw) - 1;
    float sum = 0.0;
    for (int i = -2; i <= 2; ++i)
        sum += LOAD_TEXTURE2D_X(_PenumbraSourceTexture, min(max(texel + i * direction, low), high)).x;
    return sum / 5.0;
}
float4 Rows(ScreenVaryings input) : SV_Target { return MeanAlong(int2(input.positionCS.xy), int2(1, 0)); }
float4 Columns(ScreenVaryings input) : SV_Target { return MeanAlong(int2(input.positionCS.xy), int2(0, 1)); }
float4 Mips(ScreenVaryings input) : SV_Target
{
    const int2 first = 2 * int2(input.positionCS.xy);
    float sum = 0.0;
    for (int i = 0; i < 4; ++i)
        sum += LOAD_TEXTURE2D_X(_PenumbraSourceTexture, first + int2(i % 2, i / 2)).x;
    return 0.25 * sum;
}
