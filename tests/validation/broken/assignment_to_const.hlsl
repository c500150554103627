// assignment_to_const.hlsl:5:11: error: l-value required (can't modify a const) 'assign'
static const float scale = 2.0;
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    scale = uv.x;
    return scale;
}
