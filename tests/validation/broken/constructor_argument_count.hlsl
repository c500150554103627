// constructor_argument_count.hlsl:4:12: error: the constructor float4 takes 4 numbers, and has 3
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return float4(uv, 1.0);
}
