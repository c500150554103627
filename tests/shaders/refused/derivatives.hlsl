// derivatives.hlsl:11: error: a texture is sampled with derivatives, which a vertex program does not have: use SampleLevel or SampleGrad
// derivatives.hlsl:14: error: a texture is sampled with derivatives, which a vertex program does not have: use SampleLevel or SampleGrad
// derivatives.hlsl:15: error: a texture is sampled with derivatives, which a vertex program does not have: use SampleLevel or SampleGrad
// derivatives.hlsl:16: error: a texture is sampled with derivatives, which a vertex program does not have: use SampleLevel or SampleGrad
// derivatives.hlsl:17: error: ddx needs derivatives, which a vertex program does not have
// derivatives.hlsl:18: error: CalculateLevelOfDetail needs derivatives, which a vertex program does not have
// derivatives.hlsl:21: error: a texture is sampled with derivatives, which a compute program does not have: use SampleLevel or SampleGrad
// compile: --stage vertex --entry Vertex
// compile: --stage compute --entry Kernel
Texture2D<float4> _Map; SamplerState sampler_Map; SamplerComparisonState _Compare; RWTexture2D<float4> _Out;
float4 Read(float2 uv) { return _Map.Sample(sampler_Map, uv); }
float4 Vertex(float4 p : POSITION) : SV_Position
{
    float4 a = _Map.Sample(sampler_Map, p.xy);
    float4 b = _Map.SampleBias(sampler_Map, p.xy, 1);
    float c = _Map.SampleCmp(_Compare, p.xy, 1);
    float4 d = ddx(p);
    float e = _Map.CalculateLevelOfDetail(sampler_Map, p.xy);
    return a + b + c + d + e + Read(p.yx);
}
[numthreads(8, 8, 1)] void Kernel(uint3 id : SV_DispatchThreadID) { _Out[id.xy] = _Map.Sample(sampler_Map, id.xy); }
