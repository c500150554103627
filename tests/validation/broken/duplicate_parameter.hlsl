// duplicate_parameter.hlsl:2:29: error: redefinition 'a'
float Sum(float a, float a) { return a; }
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Sum(uv.x, uv.y);
}
