// macro_too_many_arguments.hlsl:5:12: error: too many arguments for macro 'TWICE'
#define TWICE(a) ((a) * 2.0)
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return TWICE(uv.x, uv.y);
}
