// constructor_argument_count.hlsl:4:12: error: too few components for this constructor
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return float4(uv, 1.0);
}
