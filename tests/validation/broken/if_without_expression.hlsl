// if_without_expression.hlsl:2:1: error: this condition has no value
#if
#endif
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
