// Test: one comparison per thread. _Points: atlas UV, reference depth, unused.
Texture2D<float> _Map;
SamplerComparisonState _Compare;
StructuredBuffer<float4> _Points;
RWStructuredBuffer<float> _Result;

[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    const float4 at = _Points[id.x];
    _Result[id.x] = _Map.SampleCmpLevelZero(_Compare, at.xy, at.z);
}
