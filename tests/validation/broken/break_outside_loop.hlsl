// break_outside_loop.hlsl:4:10: error: expected 'loop or switch', found ';'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    break;
    return uv.xyxy;
}
