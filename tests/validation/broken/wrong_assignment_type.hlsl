// wrong_assignment_type.hlsl:4:19: error: '=': cannot convert from 'float2' to 'float3'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float3 normal = uv;
    return normal.xyzz;
}
