// unknown_package.hlsl:2:1: error: cannot find 'Packages/com.example.tool/Noise.hlsl'; tried Packages/com.example.tool/Noise.hlsl; no package root is given for 'com.example.tool'; did you mean 'com.example.tools'?
#include "Packages/com.example.tool/Noise.hlsl"
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
