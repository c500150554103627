// wrong_return_type.hlsl:2:17: error: type does not match, or is not convertible to, the function's return type 'return'
float3 Tint() { return float2(0.5, 0.25); }
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Tint().xyzz;
}
