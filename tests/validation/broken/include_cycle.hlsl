// parts/cycle_b.hlsl:1:1: error: includes nest too deeply: parts/cycle_a.hlsl -> parts/cycle_b.hlsl -> parts/cycle_a.hlsl
#include "parts/cycle_a.hlsl"
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
