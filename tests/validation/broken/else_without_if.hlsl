// else_without_if.hlsl:4:5: error: expected 'declaration', found 'else'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    else return 1.0;
    return uv.xyxy;
}
