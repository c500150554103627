// invalid_number.hlsl:4: error: expected ';'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * 1.5.5;
}
