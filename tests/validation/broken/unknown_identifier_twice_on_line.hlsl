// unknown_identifier_twice_on_line.hlsl:4:22: error: unknown variable 'shade'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * shade + shade;
}
