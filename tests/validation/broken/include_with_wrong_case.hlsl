// include_with_wrong_case.hlsl:2:1: error: cannot find 'parts/Palette.hlsl'; tried parts/Palette.hlsl; did you mean parts/palette.hlsl?
#include "parts/Palette.hlsl"
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * paletteScale;
}
