// wrong_argument_type.hlsl:6:24: error: cannot convert input argument, argument 1
Texture2D<float4> _BaseMap;
float Blend(float a, float b) { return a + b; }
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Blend(uv.x, _BaseMap);
}
