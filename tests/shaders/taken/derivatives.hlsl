// compile: --stage vertex --entry Uncalled
// compile: --stage vertex --entry Unread
// compile: --entry Fragment
Texture2D<float4> _Map; SamplerState sampler_Map; SamplerComparisonState _Compare;
float4 Read(float2 uv) { return _Map.Sample(sampler_Map, uv); }
float4 Uncalled(float4 p : POSITION) : SV_Position
{
    return _Map.SampleLevel(sampler_Map, p.xy, 0) + _Map.SampleCmpLevelZero(_Compare, p.xy, 1) +
           _Map.SampleGrad(sampler_Map, 0, 0, 0);
}
float4 Unread(float4 p : POSITION) : SV_Position
{
    float4 unused = Read(p.xy);
    if (false) p = Read(p.xy);
    return p;
}
float4 Fragment(float4 p : SV_Position) : SV_Target { return ddx(p) + _Map.Sample(sampler_Map, p.xy); }
