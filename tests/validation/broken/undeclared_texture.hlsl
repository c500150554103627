// undeclared_texture.hlsl:5:12: error: unknown variable '_BaseMap'
SamplerState sampler_BaseMap;
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return _BaseMap.Sample(sampler_BaseMap, uv);
}
