// include_of_itself.hlsl:2:1: error: includes nest too deeply: include_of_itself.hlsl -> include_of_itself.hlsl
#include "include_of_itself.hlsl"
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
