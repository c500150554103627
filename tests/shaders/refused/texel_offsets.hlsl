// texel_offsets.hlsl:9: error: the offset of a texture read is 8 texels, and must be from -8 to 7
// texel_offsets.hlsl:10: error: the offset of a texture read is -9 texels, and must be from -8 to 7
// texel_offsets.hlsl:11: error: the offset of a texture read is 9 texels, and must be from -8 to 7
// texel_offsets.hlsl:12: error: the offset of a texture read is 8 texels, and must be from -8 to 7
// texel_offsets.hlsl:13: error: the offset of a texture read must be a constant from -8 to 7; if it depends on a loop counter, write [unroll] before the loop
Texture2D<float4> _Map; SamplerState sampler_Map; SamplerComparisonState _Compare; int2 _Texel;
float4 Main(float4 p : SV_Position) : SV_Target
{
    float4 a = _Map.Sample(sampler_Map, p.xy, int2(0, 8));
    float4 b = _Map.SampleGrad(sampler_Map, p.xy, 0, 0, int2(-9, 0));
    float c = _Map.SampleCmpLevelZero(_Compare, p.xy, 0, int2(9, 0));
    float4 d = _Map.Load(int3(p.xy, 0), int2(8, 1));
    float4 e = _Map.Sample(sampler_Map, p.xy, _Texel);
    return a + b + c + d + e;
}
