// repeated_globals.hlsl:7:7: error: '_A' is already declared, at repeated_globals.hlsl:6: remove one of the two
// repeated_globals.hlsl:8:8: error: '_A' is already declared, at repeated_globals.hlsl:6: remove one of the two
// repeated_globals.hlsl:13:18: error: '_C' is already declared, at repeated_globals.hlsl:11: remove one of the two
// repeated_globals.hlsl:14:11: error: '_T' is already declared, at parts/texture.hlsl:1: remove one of the two
#include "parts/texture.hlsl"
float _A;
float _A;
float4 _A;
cbuffer C
{
    float _B; float _C;
};
static float _D, _C;
Texture2D _T;
float4 Main() : SV_Target { return 1; }
