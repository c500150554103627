// error_directive.hlsl:3:1: error: '#error': Choose a quality: define _QUALITY as 0, 1 or 2
#ifndef _QUALITY
#error Choose a quality: define _QUALITY as 0, 1 or 2
#endif
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
