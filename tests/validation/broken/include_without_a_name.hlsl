// include_without_a_name.hlsl:2:1: error: '#include' needs a "file" or a <file>
#include PALETTE
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
