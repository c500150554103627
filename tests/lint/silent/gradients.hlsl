// The rules find an expression once in a shader, so that each read has coordinates of its own.
Texture2D _Map; SamplerState sampler_Map; float _Cut; int _Count;
float4 UnderAUniformCondition(float2 uv, int flat)
{
    float4 c = 0;
    if (_Cut > 0.5) c += _Map.Sample(sampler_Map, 2 * uv);
    if (flat > 1) c += _Map.Sample(sampler_Map, 3 * uv);
    return c;
}
float4 WithLevelOrGradients(float2 uv)
{
    float4 c = 0;
    if (uv.x > 0.5) c += _Map.SampleLevel(sampler_Map, 4 * uv, 0);
    if (uv.x > 0.5) c += _Map.SampleGrad(sampler_Map, 5 * uv, 0.1, 0.1);
    return c;
}
float4 BeforeAndAfterTheCondition(float2 uv)
{
    float4 c = _Map.Sample(sampler_Map, 6 * uv);
    if (uv.x > 0.5) c *= 2;
    return c + _Map.Sample(sampler_Map, 7 * uv);
}
float4 AfterAnEarlyReturnOfAll(float2 uv) { if (_Cut > 0.5) return 0; return _Map.Sample(sampler_Map, 8 * uv); }
float4 AfterDiscard(float2 uv) { if (uv.x > 0.5) discard; return _Map.Sample(sampler_Map, 9 * uv); }
float4 AfterClip(float2 uv) { clip(uv.x - _Cut); return _Map.Sample(sampler_Map, 10 * uv); }
void Cut(float a) { if (a > 0.5) discard; }
float4 AfterDiscardInAFunction(float2 uv) { Cut(uv.x); return _Map.Sample(sampler_Map, 11 * uv); }
float4 Read(float2 uv) { return _Map.Sample(sampler_Map, 12 * uv); }
float4 ThroughAUniformVariable(float2 uv)
{
    float4 c = 0;
    bool hit = false;
    if (_Cut > 0.5) hit = true;
    if (hit) c += _Map.Sample(sampler_Map, 13 * uv);
    return c;
}
float4 Loops(float2 uv)
{
    float4 c = 0;
    for (int i = 0; i < _Count; ++i) c += _Map.Sample(sampler_Map, 14 * uv);
    [loop] for (int j = 0; j < 4; ++j) c += _Map.Sample(sampler_Map, 15 * uv);
    int k = 0;
    for (; k < 8; ++k) if (k > uv.x * 8) break;
    return c + _Map.Sample(sampler_Map, 16 * uv);
}
// FXC reports these two (X3570, X3511).
float4 LoopWithoutABound(float2 uv)
{
    float4 c = 0;
    for (int i = 0; i < uv.x * 8; ++i)
        c += _Map.Sample(sampler_Map, 17 * uv);
    return c;
}
float4 LoopWithABreak(float2 uv)
{
    float4 c = 0;
    for (int i = 0; i < 8; ++i)
    {
        if (i > uv.x * 8) break;
        c += _Map.Sample(sampler_Map, 18 * uv);
    }
    return c;
}
float4 Main(float2 uv : TEXCOORD0, nointerpolation int flat : TEXCOORD1) : SV_Target
{
    float4 c = UnderAUniformCondition(uv, flat) + WithLevelOrGradients(uv) + BeforeAndAfterTheCondition(uv);
    c += AfterAnEarlyReturnOfAll(uv) + AfterDiscard(uv) + AfterClip(uv) + AfterDiscardInAFunction(uv) + Read(uv);
    return c + ThroughAUniformVariable(uv) + Loops(uv) + LoopWithoutABound(uv) + LoopWithABreak(uv);
}
