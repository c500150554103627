// calls_of_textures.hlsl:5:20: error: expected: SamplerComparisonState
Texture2D<float4> _Map; SamplerState sampler_Map;
float4 Main(float4 p : SV_Position) : SV_Target
{
    float z = _Map.SampleCmp(sampler_Map, p.xy, 0.5);
    return z;
}
