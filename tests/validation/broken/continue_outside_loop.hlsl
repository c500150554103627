// continue_outside_loop.hlsl:4:29: error: expected 'loop', found ';'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    if (uv.x > 0.5) continue;
    return uv.xyxy;
}
