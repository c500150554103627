// structure_in_arithmetic.hlsl:7:20: error: Could not perform requested binary operation
struct Surface { float3 normal; };
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    Surface surface;
    surface.normal = 1.0;
    return uv.xyxy * surface;
}
