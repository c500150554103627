// constant_index_out_of_bounds.hlsl:5:19: error: '[': array index out of range '4'
static const float weights[4] = { 0.1, 0.2, 0.3, 0.4 };
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return weights[4];
}
