// lost_resources.hlsl: error: a texture is selected at run time, which HLSL does not allow; read both and select between the results
// lost_resources.hlsl:13: error: a texture is read uninitialised; if every path does initialise it, one function reads it both with a comparison sampler and with another sampler, which glslang miscompiles: use a separate function for each
// lost_resources.hlsl:14: error: a sampler is read uninitialised; if every path does initialise it, one function reads it both with a comparison sampler and with another sampler, which glslang miscompiles: use a separate function for each
// lost_resources.hlsl:16: error: a texture is read uninitialised; if every path does initialise it, one function reads it both with a comparison sampler and with another sampler, which glslang miscompiles: use a separate function for each
// lost_resources.hlsl:20: error: a sampler is read uninitialised; if every path does initialise it, one function reads it both with a comparison sampler and with another sampler, which glslang miscompiles: use a separate function for each
// compile: --stage compute --entry TwoWays
// compile: --stage compute --entry UnsetTexture
// compile: --stage compute --entry UnsetSampler
// compile: --stage compute --entry UnsetMember
// compile: --stage compute --entry Chosen
Texture2D A; Texture2D B; SamplerState S; SamplerComparisonState C; RWStructuredBuffer<float> _Out;
struct Pair { Texture2D t; SamplerState s; float n; };
float Both(Texture2D t) { return t.SampleLevel(S, 0.5, 0).x + t.SampleCmpLevelZero(C, 0.5, 0.5); }
float OfPair(Pair p) { return p.t.SampleLevel(p.s, 0.5, 0).x; }
[numthreads(1, 1, 1)] void TwoWays(uint3 id : SV_DispatchThreadID) { _Out[id.x] = Both(A); }
[numthreads(1, 1, 1)] void UnsetTexture(uint3 id : SV_DispatchThreadID) { Texture2D t; _Out[id.x] = t.Load(0).x; }
[numthreads(1, 1, 1)] void UnsetSampler(uint3 id : SV_DispatchThreadID)
{
    SamplerState s;
    _Out[id.x] = A.SampleLevel(s, 0.5, 0).x;
}
[numthreads(1, 1, 1)] void UnsetMember(uint3 id : SV_DispatchThreadID)
{
    Pair p; p.t = A; p.n = 1;
    _Out[id.x] = OfPair(p);
}
[numthreads(1, 1, 1)] void Chosen(uint3 id : SV_DispatchThreadID)
{
    Texture2D t; if (id.x > 0) t = A; else t = B;
    _Out[id.x] = t.Load(0).x;
}
