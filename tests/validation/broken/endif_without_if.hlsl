// endif_without_if.hlsl:5:1: error: '#endif' has no '#if' in this file
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
#endif
}
