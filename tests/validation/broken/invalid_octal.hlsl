// invalid_octal.hlsl:4:22: error: a number that starts with 0 is octal: no digit is above 7
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * 089;
}
