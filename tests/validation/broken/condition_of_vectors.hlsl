// condition_of_vectors.hlsl:4:5: error: 'conditional expression': requires a scalar
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    if (uv > 0.5)
        return 1.0;
    return 0.0;
}
