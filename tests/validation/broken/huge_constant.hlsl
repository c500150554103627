// huge_constant.hlsl:4:23: error: this number is too big for an int
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * (99999999999999999999 & 7);
}
