// variable_array_size.hlsl:5:16: error: array size must be a constant integer expression
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    int count = 4;
    float taps[count];
    taps[0] = uv.x;
    return taps[0];
}
