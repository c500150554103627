// extra_parenthesis.hlsl:4:33: error: expected ';'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float shade = saturate(uv.x));
    return shade.xxxx;
}
