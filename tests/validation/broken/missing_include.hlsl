// missing_include.hlsl:2:1: error: cannot find 'parts/pallete.hlsl'; tried parts/pallete.hlsl; did you mean parts/palette.hlsl?
#include "parts/pallete.hlsl"
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy * paletteScale;
}
