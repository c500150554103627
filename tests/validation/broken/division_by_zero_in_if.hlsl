// division_by_zero_in_if.hlsl:2:1: error: in this condition: division by 0
#if 4 / 0
#endif
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
