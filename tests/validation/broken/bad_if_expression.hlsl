// bad_if_expression.hlsl:2:1: error: in this condition: '(' is never closed
#if (_QUALITY > 1
#define SHADE 1.0
#else
#define SHADE 0.5
#endif
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return SHADE;
}
