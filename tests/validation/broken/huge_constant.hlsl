// huge_constant.hlsl:4:23: error: numeric literal too big
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * (99999999999999999999 & 7);
}
