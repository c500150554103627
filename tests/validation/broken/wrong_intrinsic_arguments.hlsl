// wrong_intrinsic_arguments.hlsl:4:12: error: no matching overloaded function found 'lerp'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return lerp(uv.x, uv.y).xxxx;
}
