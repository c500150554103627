// Test: x x + y in half, each operation on its own.
StructuredBuffer<float2> _Numbers;
RWStructuredBuffer<float> _Result;

[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    const half x = half(_Numbers[id.x].x);
    const half y = half(_Numbers[id.x].y);
    precise half product = x * x;
    precise half sum = product + y;
    _Result[id.x] = float(sum);
}
