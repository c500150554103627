// wrong_assignment_type.hlsl:4:19: error: '=': cannot convert from ' in 2-component vector of float' to ' temp 3-component vector of float'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float3 normal = uv;
    return normal.xyzz;
}
