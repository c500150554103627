// bad_register.hlsl:2:22: warning: 'q' is not a kind of register: use b, t, s, u or c
Texture2D _BaseMap : register(q0);
SamplerState sampler_BaseMap;
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return _BaseMap.Sample(sampler_BaseMap, uv);
}
