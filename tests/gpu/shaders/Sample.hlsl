// Test: one filtered read per thread.
Texture2D<float4> _Map;
SamplerState _Sampler;
StructuredBuffer<float4> _Points;
RWStructuredBuffer<float4> _Result;

[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    _Result[id.x] = _Map.SampleLevel(_Sampler, _Points[id.x].xy, 0.0);
}
