// return_without_value.hlsl:3:1: error: function does not return a value: Shade
float Shade(float x)
{
    return;
}
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Shade(uv.x);
}
