// components.hlsl:22:18: error: '.stpq' is not a swizzle of HLSL, which has xyzw and rgba: write '.xyzw'
// components.hlsl:23:7: error: '.ts' is not a swizzle of HLSL, which has xyzw and rgba: write '.yx'
// components.hlsl:24:42: error: '.st' is not a swizzle of HLSL, which has xyzw and rgba: write '.xy'
// components.hlsl:25:19: error: '.st' is not a swizzle of HLSL, which has xyzw and rgba: write '.xy'
// components.hlsl:25:37: error: '.s' is not a swizzle of HLSL, which has xyzw and rgba: write '.x'
// components.hlsl:26:7: error: '.xx' has x twice, and cannot be written: name each component once
// components.hlsl:27:7: error: '.xyx' has x twice, and cannot be written: name each component once
// components.hlsl:28:7: error: '.gg' has g twice, and cannot be written: name each component once
// components.hlsl:29:7: error: '.xx' has x twice, and cannot be written: name each component once
// components.hlsl:30:9: error: '.zz' has z twice, and cannot be written: name each component once
// components.hlsl:31:7: error: '._m00_m00' has _m00 twice, and cannot be written: name each component once
// components.hlsl:32:7: error: '._11_11' has _11 twice, and cannot be written: name each component once
// components.hlsl:33:8: error: '.xx' has x twice, and cannot be written: name each component once
// components.hlsl:34:9: error: '.yy' has y twice, and cannot be written: name each component once
// components.hlsl:35:14: error: '._m00_11' mixes zero-based and one-based subscripts: write _m00 or _11 throughout
// components.hlsl:36:7: error: '._12_m01' mixes zero-based and one-based subscripts: write _m00 or _11 throughout
Texture2D t; SamplerState sampler_t;
struct S { float2 s; };
float4 Main(float4 c : COLOR) : SV_Target
{
    float3 v; float4x4 m; S s;
    float4 a = c.stpq;
    a.ts = c.xy;
    float2 b = t.Sample(sampler_t, c.xy).st;
    s.s = (c * 2).st; float d = s.s.s;
    c.xx = c.xy;
    v.xyx = 1;
    v.gg += 2;
    v.xx++;
    --v.zz;
    m._m00_m00 = 1;
    m._11_11 = 1;
    (c.xx) = 1;
    ((v.yy)) += 1;
    v.xy = m._m00_11;
    m._12_m01 = 1;
    return 1;
}
