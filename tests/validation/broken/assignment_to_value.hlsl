// assignment_to_value.hlsl:4:17: error: l-value required 'assign'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    uv.x + uv.y = 1.0;
    return uv.xyxy;
}
