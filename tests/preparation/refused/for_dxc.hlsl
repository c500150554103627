// for_dxc.hlsl:3:71: error: 'a' at for_dxc.hlsl:3 has the semantic 'TEXCOORD2', too: give each input its own
#pragma use_dxc
float4 Main(float2 a[2] : TEXCOORD1, float2 b : TEXCOORD0, float2 c : TEXCOORD2) : SV_Target
{
    return 1;
}
