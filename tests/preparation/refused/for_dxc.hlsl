// for_dxc.hlsl:5:8: warning: shaders do not read strings: this variable has no effect
// for_dxc.hlsl:6:71: error: 'a' at for_dxc.hlsl:6 has the semantic 'TEXCOORD2', too: give each input its own
// for_dxc.hlsl:8:12: error: strings may only be declared at file scope, and shaders do not read them: remove it
#pragma use_dxc
string s = "a";
float4 Main(float2 a[2] : TEXCOORD1, float2 b : TEXCOORD0, float2 c : TEXCOORD2) : SV_Target
{
    string t = "a";
    return 1;
}
