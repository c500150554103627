// negative_array_size.hlsl:5:9: error: '[': array index out of range '0'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float taps[-2];
    taps[0] = uv.x;
    return taps[0];
}
