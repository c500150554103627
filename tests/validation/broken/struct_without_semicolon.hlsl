// struct_without_semicolon.hlsl:5:2: error: expected ';'
struct Surface
{
    float3 normal;
}
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
