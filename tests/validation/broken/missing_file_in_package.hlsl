// missing_file_in_package.hlsl:2:1: error: cannot find 'Packages/com.example.tools/Nose.hlsl'; tried packages/tools/Nose.hlsl, Packages/com.example.tools/Nose.hlsl; did you mean packages/tools/Noise.hlsl?
#include "Packages/com.example.tools/Nose.hlsl"
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
