// Test: the bits a shader sees in every texel of a map.
Texture2D<float> _Map;
RWStructuredBuffer<uint> _Result;

[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    uint width;
    uint height;
    _Map.GetDimensions(width, height);
    _Result[id.y * width + id.x] = asuint(_Map.Load(int3(id.xy, 0)));
}
