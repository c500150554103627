// bad_register.hlsl:2:31: error: register 'q0' does not exist: they are b0 (constant buffers), t0 (textures and buffers), s0 (samplers), u0 (writable ones), and those after them
Texture2D _BaseMap : register(q0);
SamplerState sampler_BaseMap;
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return _BaseMap.Sample(sampler_BaseMap, uv);
}
