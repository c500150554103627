// bad_swizzle.hlsl:4:15: error: '.xyz' asks for components that the vector does not have
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyz.xyzz;
}
