// parts/open_condition.hlsl:1:1: error: '#ifndef' has no '#endif' in this file
#include "parts/open_condition.hlsl"
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
