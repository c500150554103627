// unknown_member.hlsl:7:20: error: no such field in structure 'albedo'
struct Surface { float3 normal; };
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    Surface surface;
    surface.normal = float3(uv, 0.0);
    return surface.albedo.xyzz;
}
