// bad_swizzle.hlsl:4:15: error: vector swizzle selection out of range 'xyz'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyz.xyzz;
}
