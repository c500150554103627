// unknown_directive.hlsl:2:1: error: unknown directive '#defin'
#defin SHADE 0.5
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
