// unknown_texture_method.hlsl:6:21: error: no matching overloaded function found 'Smaple'
Texture2D _BaseMap;
SamplerState sampler_BaseMap;
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return _BaseMap.Smaple(sampler_BaseMap, uv);
}
