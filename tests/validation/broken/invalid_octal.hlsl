// invalid_octal.hlsl:4:22: error: octal literal digit too large
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * 089;
}
