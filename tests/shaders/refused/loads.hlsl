// loads.hlsl:6: error: this Load takes an int3, the last for the mip level, and its argument has 2 components
// loads.hlsl:7: error: this Load takes an int4, the last for the mip level, and its argument has 3 components
Texture2D<float4> _Map; Texture2DArray<float4> _Layers;
float4 Main(float4 p : SV_Position) : SV_Target
{
    float4 a = _Map.Load(int2(p.xy));
    return a + _Layers.Load(int3(p.xyz));
}
