// missing_brace.hlsl:9: error: expected 'declaration'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    if (uv.x > 0.5)
    {
        return 1.0;
    return 0.0;
}
