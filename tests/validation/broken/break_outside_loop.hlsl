// break_outside_loop.hlsl:4:5: error: 'break' is outside of every loop and switch
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    break;
    return uv.xyxy;
}
