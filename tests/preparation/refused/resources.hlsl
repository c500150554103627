// resources.hlsl:22:25: error: register 's0' is not one for a Texture2D, whose registers begin with 't'
// resources.hlsl:23:35: error: register 't3' is not one for a RWTexture2D, whose registers begin with 'u'
// resources.hlsl:24:23: error: register 't1' is not one for a cbuffer, whose registers begin with 'b'
// resources.hlsl:25:23: error: register 'b20' does not exist in Direct3D 11, which has b0 to b13
// resources.hlsl:26:27: error: register 's16' does not exist in Direct3D 11, which has s0 to s15
// resources.hlsl:27:25: error: register 'q1' does not exist: they are b0 (constant buffers), t0 (textures and buffers), s0 (samplers), u0 (writable ones), and those after them
// resources.hlsl:34:5: error: 'tex2D' takes a sampler2D, and 't' is a Texture2D: write t.Sample() with a SamplerState
// resources.hlsl:35:5: error: 'tex2Dlod' takes a sampler2D, and 's.t' is a Texture2D: write s.t.Sample() with a SamplerState
// resources.hlsl:36:7: error: a sampler2D has no method 'Sample': sample it with tex2D()
// resources.hlsl:37:7: error: a SamplerState has no method 'Sample': call it on the texture
// resources.hlsl:38:17: error: 'Load' takes no type in '<>' here: read or write uints, and convert them with asfloat(), asint() or asuint()
// resources.hlsl:39:18: error: '.sample[][]' is not supported: write m.Load(texel, sample)
// resources.hlsl:40:7: error: a RWTexture2D has no method 'Store': write w[texel] = value
// resources.hlsl:41:5: error: 'grows' is an AppendStructuredBuffer, which has Append() and no []: for elements by number declare a StructuredBuffer or RWStructuredBuffer
// resources.hlsl:42:15: error: 'shrinks' is a ConsumeStructuredBuffer, which has Consume() and no []: for elements by number declare a StructuredBuffer or RWStructuredBuffer
// resources.hlsl:43:21: error: AppendStructuredBuffer has no method 'Consume': it belongs to ConsumeStructuredBuffer
// resources.hlsl:44:7: error: RWStructuredBuffer has no method 'Append': it belongs to AppendStructuredBuffer
// resources.hlsl:45:20: error: 't' is a Texture2D, and max() takes numbers: read it with Sample or Load
// resources.hlsl:46:29: error: 'A[1]' is a Texture2D, and max() takes numbers: read it with Sample or Load
// resources.hlsl:47:30: error: 't' is a Texture2D, and lerp() takes numbers: read it with Sample or Load
// resources.hlsl:48:20: error: 'p' is a SamplerState, and dot() takes numbers
Texture2D t1 : register(s0);
RWTexture2D<float4> t2 : register(t3);
cbuffer C1 : register(t1) { float c1; };
cbuffer C2 : register(b20) { float c2; };
SamplerState s : register(s16);
Texture2D t3 : register(q1);
Texture2D t, A[2]; SamplerState p; sampler2D d; Texture2DMS<float4, 4> m; ByteAddressBuffer b; RWTexture2D<float4> w;
AppendStructuredBuffer<float> grows; ConsumeStructuredBuffer<float> shrinks; RWStructuredBuffer<float> r;
struct S { Texture2D t; };
float4 Main(float2 uv : TEXCOORD0) : SV_Target
{
    S s; s.t = t;
    tex2D(t, uv);
    tex2Dlod(s.t, uv.xyxy);
    d.Sample(p, uv);
    p.Sample(p, uv);
    float f = b.Load<float>(0);
    float4 c = m.sample[1][uint2(uv)];
    w.Store(uint2(uv), 1);
    grows[0] = 1;
    float g = shrinks[1];
    float h = grows.Consume();
    r.Append(1);
    float4 i = max(t, uv.xyxy);
    float4 j = max(uv.xyxy, A[1]);
    float4 k = lerp(uv.xyxy, t, .5);
    float4 l = dot(p, uv.xyxy);
    return 1;
}
