// wrong_bracket.hlsl:5:21: error: expected 'expression followed by ']'', found ')'
static const float weights[2] = { 0.25, 0.75 };
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return weights[0) * uv.xyxy;
}
