// macro_too_few_arguments.hlsl:5:12: error: too few arguments for macro 'BLEND'
#define BLEND(a, b, t) ((a) + ((b) - (a)) * (t))
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return BLEND(uv.x, uv.y);
}
