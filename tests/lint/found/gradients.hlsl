// gradients.hlsl:15:19: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 14: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:21:17: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 20: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:23:65: warning: a derivative is taken where only some pixels of a quad may be active, by the condition at line 23: take it before the condition [divergent-derivative]
// gradients.hlsl:24:60: warning: a derivative is taken where only some pixels of a quad may be active, by the condition at line 24: take it before the condition [divergent-derivative]
// gradients.hlsl:27:17: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 32: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:40:24: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:48:26: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 48: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// gradients.hlsl:55:37: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 55: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// The rules find an expression once in a shader, so that each read has coordinates of its own.
Texture2D _Map; SamplerState sampler_Map;
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
float4 ConditionInALoop(float2 uv)
{
    float4 c = 0;
    for (int i = 0; i < 8; ++i)
        if (i > uv.x * 8) c += _Map.Sample(sampler_Map, 9 * uv);
    return c;
}
float4 Main(float2 uv : TEXCOORD0) : SV_Target
{
    float4 c = UnderACondition(uv) + AfterAnEarlyReturn(uv) + Derivative(uv) + Width(uv) + CalledUnderACondition(uv);
    return c + ThroughAVariable(uv) + AfterALoop(uv) + ConditionInALoop(uv);
}
