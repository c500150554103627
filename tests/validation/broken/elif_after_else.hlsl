// elif_after_else.hlsl:6:1: error: '#elif' comes after '#else'
#if defined(_A)
#define SHADE 1.0
#else
#define SHADE 0.5
#elif defined(_B)
#define SHADE 0.25
#endif
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return SHADE;
}
