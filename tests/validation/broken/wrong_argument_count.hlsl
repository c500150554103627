// wrong_argument_count.hlsl:5:12: error: no matching overloaded function found 'Blend'
float Blend(float a, float b, float t) { return a + (b - a) * t; }
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Blend(uv.x, uv.y);
}
