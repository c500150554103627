Texture2D<float4> _Map; SamplerState sampler_Map;
float4 Main(float4 p : SV_Position) : SV_Target
{
    float4 sum = _Map.Gather(sampler_Map, p.xy, int2(9, 0)) + _Map.Sample(sampler_Map, p.xy, int2(-8, 7));
    [unroll] for (int i = -2; i <= 2; ++i) sum += _Map.Sample(sampler_Map, p.xy, int2(i, 0));
    return sum;
}
