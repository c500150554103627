// macro_of_itself.hlsl:5:22: error: unknown variable 'SHADE'
#define SHADE SHADE * 0.5
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * SHADE;
}
