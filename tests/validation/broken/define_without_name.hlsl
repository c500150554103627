// define_without_name.hlsl:2:1: error: '#define' names no macro
#define
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
