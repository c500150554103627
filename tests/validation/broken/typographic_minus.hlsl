// typographic_minus.hlsl:4:17: error: unexpected token '−'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.x − uv.yyyy;
}
