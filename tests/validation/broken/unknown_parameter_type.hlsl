// unknown_parameter_type.hlsl:2:17: error: expected ')', found 'Colour'
float Luminance(Colour c) { return c.g; }
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
