// undeclared_sampler.hlsl:5:28: error: unknown variable 'sampler_BaseMap'
Texture2D _BaseMap;
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return _BaseMap.Sample(sampler_BaseMap, uv);
}
