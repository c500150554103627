// Test: the samples of one pixel, and values of the lanes of a subgroup.
Texture2DMS<float4> _Samples;
RWStructuredBuffer<float> _Result;

[numthreads(1, 1, 1)] void OfPixel(uint3 id : SV_DispatchThreadID)
{
    _Result[id.x] = _Samples.Load(int2(0, 0), id.x).x;
}

[numthreads(32, 1, 1)] void Sums(uint3 id : SV_DispatchThreadID)
{
    _Result[id.x] = WaveActiveSum(float(id.x));
    _Result[32 + id.x] = WaveGetLaneCount();
}
