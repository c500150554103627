cbuffer C : register(b13) { float c1; }; Texture2D t0 : register(t0, space1);
SamplerState s : register(ps_5_0, s[2]); sampler2D d : register(s1); float4 k : register(c4);
RWStructuredBuffer<float> u : register(u7); ByteAddressBuffer b : register(T3); static float x = 1;
tbuffer B : register(t4) { float z; };
Texture2D t, A[2]; SamplerState p; Texture2DMS<float4, 4> m; RWTexture2D<float4> w;
AppendStructuredBuffer<float> a; ConsumeStructuredBuffer<float> c; RWStructuredBuffer<float> r;
float4 Main(float2 uv : TEXCOORD0) : SV_Target
{
    t.Sample(p, uv); tex2D(d, uv); b.Load(0); m.Load(uv, 1); w[uint2(uv)] = 1;
    a.Append(c.Consume()); r[0] = r[1];
    return max(t.Sample(p, uv), A[1].Load(int3(0, 0, 0)));
}
