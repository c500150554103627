// macro_redefined.hlsl:3:9: warning: macro 'SHADE' is defined as something else at macro_redefined.hlsl:2; from here on this definition is used
#define SHADE 0.5
#define SHADE 0.25
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * SHADE;
}
