// missing_semicolon_last_statement.hlsl:4:19: error: expected ';'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy
}
