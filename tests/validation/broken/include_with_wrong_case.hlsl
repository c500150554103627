// include_with_wrong_case.hlsl:2:11: warning: 'parts/Palette.hlsl' names parts/palette.hlsl in another case; only disks that ignore case find it
#include "parts/Palette.hlsl"
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * paletteScale;
}
