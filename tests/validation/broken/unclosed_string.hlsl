// unclosed_string.hlsl:2:1: error: this '#include' has no closing '"'
#include "parts/palette.hlsl
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
