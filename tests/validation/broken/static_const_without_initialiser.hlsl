// static_const_without_initialiser.hlsl:2:20: warning: variable with qualifier 'const' not initialized; zero initializing 'scale'
static const float scale;
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * scale;
}
