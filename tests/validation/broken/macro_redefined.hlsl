// macro_redefined.hlsl:3:1: error: macro 'SHADE' is defined already as something else
#define SHADE 0.5
#define SHADE 0.25
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * SHADE;
}
