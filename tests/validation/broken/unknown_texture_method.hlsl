// unknown_texture_method.hlsl:6:21: error: no method 'Smaple' takes these arguments; did you mean 'Sample'?
Texture2D _BaseMap;
SamplerState sampler_BaseMap;
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return _BaseMap.Smaple(sampler_BaseMap, uv);
}
