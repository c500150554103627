// gradients.hlsl:19:19: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 18: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:25:17: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 24: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:27:65: warning: a derivative is taken where only some pixels of a quad may be active, by the condition at line 27: take it before the condition [divergent-derivative]
// gradients.hlsl:28:60: warning: a derivative is taken where only some pixels of a quad may be active, by the condition at line 28: take it before the condition [divergent-derivative]
// gradients.hlsl:31:17: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 36: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:44:24: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:52:26: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 52: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:59:19: error: derivatives are taken in divergent control flow: the loop's number of iterations differs between pixels, by the condition at line 58; Direct3D must unroll it and finds no bound: use SampleLevel or SampleGrad [gradient-in-varying-loop]
// gradients.hlsl:68:19: warning: derivatives are taken in divergent control flow: the loop's number of iterations differs between pixels, by the condition at line 67; Direct3D unrolls it, elsewhere they are undefined: use SampleLevel or SampleGrad [gradient-in-varying-loop]
// gradients.hlsl:76:37: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 76: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:83:5: error: [unroll] on a loop without a constant bound on its iterations: use [loop], or break after a constant number of iterations [unroll-without-bound]
// gradients.hlsl:89:14: error: [unroll] on a loop without a constant bound on its iterations: use [loop], or break after a constant number of iterations [unroll-without-bound]
// The rules find an expression once in a shader, so that each read has coordinates of its own.
Texture2D _Map; SamplerState sampler_Map; float _Cut; int _Count;
float4 UnderACondition(float2 uv)
{
    float4 c = 0;
    if (uv.x > 0.5)
        c += _Map.Sample(sampler_Map, 2 * uv);
    return c;
}
float4 AfterAnEarlyReturn(float2 uv)
{
    if (uv.x > 0.5) return 0;
    return _Map.Sample(sampler_Map, 3 * uv);
}
float Derivative(float2 uv) { float c = 0; if (uv.x > 0.5) c += ddx(uv.x); return c; }
float Width(float2 uv) { float c = 0; if (uv.x > 0.5) c += fwidth(uv.y); return c; }
float4 Read(float2 uv)
{
    return _Map.Sample(sampler_Map, 4 * uv);
}
float4 CalledUnderACondition(float2 uv)
{
    float4 c = 0;
    if (uv.x > 0.5) c += Read(uv);
    return c;
}
float4 ThroughAVariable(float2 uv)
{
    float4 c = 0;
    bool hit = false;
    if (uv.x > 0.5) hit = true;
    if (hit) c += _Map.Sample(sampler_Map, 5 * uv);
    return c;
}
float4 AfterALoop(float2 uv)
{
    float4 c = 0;
    int i = 0;
    for (; i < 8; ++i) if (i > uv.x * 8) break;
    if (i > 3) c += _Map.Sample(sampler_Map, 6 * uv);
    return c;
}
float4 LoopWithoutABound(float2 uv)
{
    float4 c = 0;
    for (int i = 0; i < uv.x * 8; ++i)
        c += _Map.Sample(sampler_Map, 7 * uv);
    return c;
}
float4 LoopWithABreak(float2 uv)
{
    float4 c = 0;
    for (int i = 0; i < 8; ++i)
    {
        if (i > uv.x * 8) break;
        c += _Map.Sample(sampler_Map, 8 * uv);  // one cause, one rule
    }
    return c;
}
float4 ConditionInALoop(float2 uv)
{
    float4 c = 0;
    for (int i = 0; i < 8; ++i)
        if (i > uv.x * 8) c += _Map.Sample(sampler_Map, 9 * uv);
    return c;
}
float Unrolled()
{
    float c = 0;
    [unroll]
    for (int i = 0; i < _Count; ++i) c += i;
    return c;
}
float Sum(int n)
{
    float s = 0;
    [unroll] for (int i = 0; i < n; ++i) s += i;
    return s;
}
float4 Main(float2 uv : TEXCOORD0) : SV_Target
{
    float4 c = UnderACondition(uv) + AfterAnEarlyReturn(uv) + Derivative(uv) + Width(uv) + CalledUnderACondition(uv);
    c += ThroughAVariable(uv) + AfterALoop(uv) + LoopWithoutABound(uv) + LoopWithABreak(uv) + ConditionInALoop(uv);
    return c + Unrolled() + Sum(_Count);
}
