// arithmetic.hlsl:13:15: warning: pow of a base that may be negative gives NaN: bound it with abs, max or saturate [negative-pow]
// arithmetic.hlsl:14:10: warning: pow of a base that may be negative gives NaN: bound it with abs, max or saturate [negative-pow]
// arithmetic.hlsl:15:10: warning: pow of a base that may be negative gives NaN: bound it with abs, max or saturate [negative-pow]
// arithmetic.hlsl:16:10: warning: pow of a base that may be negative gives NaN: bound it with abs, max or saturate [negative-pow]
// arithmetic.hlsl:17:48: warning: pow of a base that may be negative gives NaN: bound it with abs, max or saturate [negative-pow]
// arithmetic.hlsl:19:10: warning: pow of a base that may be negative gives NaN: bound it with abs, max or saturate [negative-pow]
// arithmetic.hlsl:21:10: warning: compilers may remove this test for NaN under fast math: test the bits, (asuint(x) & 0x7FFFFFFF) > 0x7F800000 [nan-check]
// arithmetic.hlsl:22: warning: compilers may remove this test for NaN under fast math: test the bits, (asuint(x) & 0x7FFFFFFF) > 0x7F800000 [nan-check]
// arithmetic.hlsl:23:10: warning: compilers may remove this test for infinity and NaN under fast math: test the bits, (asuint(x) & 0x7F800000) != 0x7F800000 for finite numbers [nan-check]
float _Power;
float4 Main(float2 uv : TEXCOORD0, nointerpolation int flat : TEXCOORD1) : SV_Target
{
    float a = pow(uv.x, 2.2);
    a += pow(uv.x - 0.5, _Power);
    a += pow(dot(uv, uv.yx), _Power);
    a += pow(max(uv.x, -1), _Power);
    [loop] for (int i = 8; i > flat; --i) a += pow(i + 0.5, _Power);
    float4 v = float4(uv, 0.5, -1 * uv.x); v.z = clamp(v.z, 0, 8);
    a += pow(v.w, _Power);
    float x = uv.x / uv.y, y = uv.y / uv.x, z = 1 / uv.x;
    a += isnan(x) ? 0 : x;
    a += y != y ? 0 : y;
    a += isfinite(z) ? z : 0;
    return a;
}
