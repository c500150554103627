// missing_return_type.hlsl:2:1: error: expected 'declaration', found 'Half'
Half(float x) { return 0.5 * x; }
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Half(uv.x);
}
