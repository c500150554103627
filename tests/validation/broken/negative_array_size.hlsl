// negative_array_size.hlsl:4:16: error: an array's size must be positive
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float taps[-2];
    taps[0] = uv.x;
    return taps[0];
}
