// unknown_identifier.hlsl:4:22: error: unknown variable 'brightness'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * brightness;
}
