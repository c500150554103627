// include_of_a_folder.hlsl:2:1: error: cannot read 'parts': it is a folder, not a file
#include "parts"
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
