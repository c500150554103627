// expressions.hlsl:29:21: error: an integer is divided by zero
// expressions.hlsl:30:25: error: an integer is divided by zero
// expressions.hlsl:31:21: error: an integer is divided by zero
// expressions.hlsl:32:16: error: the constructor float4 takes 4 numbers, and has 1; to repeat it, write (float4)x
// expressions.hlsl:33:18: error: the constructor float2x2 takes 4 numbers, and has 3
// expressions.hlsl:34:15: error: '~' takes integers, and its operand is a float: convert it with (int), or read its bits with asuint()
// expressions.hlsl:35:18: error: cannot convert from 'float3x3' to 'float4x4', which is larger (X3017): write a constructor with all numbers
// expressions.hlsl:36:27: error: cannot convert from 'float2' to 'float4', which is larger (X3017): write a constructor with all numbers
// expressions.hlsl:37:5: error: 'memory' is groupshared, and such variables belong outside of functions and structs
// expressions.hlsl:40:15: error: '==' compares numbers, and 's' is a struct: compare its members
// expressions.hlsl:41: error: '!=' compares numbers, and 'f' is an array: compare its elements
// expressions.hlsl:42:18: error: '&' takes integers, and an operand is a float: convert it with (int), or read its bits with asuint()
// expressions.hlsl:43: error: '<<' takes integers, and an operand is a float: convert it with (int), or read its bits with asuint()
// expressions.hlsl:44:18: error: 'msad4' is HLSL, but is not supported: write out the sums of absolute differences
// expressions.hlsl:45:21: error: 'GetRenderTargetSampleCount' is HLSL, but is not supported: pass the number in a constant buffer
// expressions.hlsl:46:22: error: the condition before this '?' has 4 components, and its values have 3 (X3019): give the condition 3 as well, as in (p.xyz > 0)
// expressions.hlsl:47:26: error: the condition before this '?' has 3 components, and its values have 2 (X3019): give the condition 2 as well, as in (p.xy > 0)
// expressions.hlsl:49:28: error: the condition before this '?' has 4 components, and its values have 3 (X3019): give the condition 3 as well, as in (p.xyz > 0)
// expressions.hlsl:50:23: error: the condition before this '?' has 4 components, and its values have 3 (X3019): give the condition 3 as well, as in (p.xyz > 0)
// expressions.hlsl:51:18: error: the condition before this '?' has 4 components, and its values have 3 (X3019): give the condition 3 as well, as in (p.xyz > 0)
// expressions.hlsl:52:23: error: the condition before this '?' has 4 components, and its values have 3 (X3019): give the condition 3 as well, as in (p.xyz > 0)
// expressions.hlsl:53:27: error: the condition before this '?' has 4 components, and its values have 3 (X3019): give the condition 3 as well, as in (p.xyz > 0)
// expressions.hlsl:54:18: error: 'Main' returns a float4: this return needs a value (X3080)
static const int N = 0; static const uint A = 3;
struct S { float a; float2 b; };
float3x3 m;
float4 Main(float4 p : SV_Position) : SV_Target
{
    int divided = 1 / 0;
    uint remainder = 8u % N;
    int by_zero = A / 0x0;
    float4 a = float4(0);
    float2x2 b = float2x2(p.xy, -1);
    float c = ~p.x;
    float4 d = ((float4x4)m)[3];
    float2 v; float4 e = (float4)v;
    groupshared float memory[8];
    S s, t;
    float f[2], g[2];
    bool same = s == t;
    bool other = f != g;
    int bits = 1 & 2.5;
    int shifted = 1.5 << 2;
    uint4 sums = msad4(1, uint2(2, 3), uint4(1, 2, 3, 4));
    float samples = GetRenderTargetSampleCount();
    float3 h = p > 0 ? p.xyz : 1;
    float2 i = p.xyz > 0 ? p.xy : 0;
    bool4 positive = p > 0;
    float3 j; j = positive ? p.xyz : 1;
    float4 k = (p > 0 ? p.xyz : p.xyz).xyzz;
    float4 l = p ? 1 : float3(1, 2, 3);
    float4 o = p == p ? 1 : p.xyz;
    float3 q = p > (p > 0 ? p.xyz : 1).xyzz ? p.xyz : 1;
    if (p.x > 0) return;
    return 1;
}
