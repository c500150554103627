// missing_parenthesis.hlsl:4:47: error: expected ')', found ';'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float shade = saturate(uv.x * (1.0 - uv.y);
    return shade.xxxx;
}
