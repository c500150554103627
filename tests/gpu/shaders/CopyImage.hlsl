// Test: copies a map. With one image in both slots it breaks Vulkan's layout rules, harmlessly.
Texture2D<float4> _Map;
RWTexture2D<float4> _Image;

[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    _Image[id.xy] = _Map.Load(int3(id.xy, 0));
}
