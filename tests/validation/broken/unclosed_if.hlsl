// unclosed_if.hlsl:4:1: error: '#ifdef' has no '#endif' in this file
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
#ifdef _RIM_LIGHT
    return 1.0;
}
